#include "tests/contract/hit_digest.h"

#include "data/digest.h"

#include <algorithm>

namespace rayshoot::contract {
namespace {

void add(Digest& digest, const vec3& v) {
    for (int axis = 0; axis < 3; ++axis) digest.add(v[axis]);
}

void add(Digest& digest, const Ray& ray) {
    add(digest, ray.origin);
    add(digest, ray.direction);
    // A NaN has many bit patterns; which one a compiler makes is its own affair.
    for (const float value : {ray.t_min, ray.t_max, ray.time})
        digest.add(std::isnan(value) ? -infinity : value);
}

void add(Digest& digest, const Hit& hit) {
    digest.add(hit.t);
    digest.add(hit.primitive);
    digest.add(hit.u);
    digest.add(hit.v);
}

void add_answers(Digest& digest, Session& session, const Stream& stream) {
    std::vector<Hit> hits(default_batch);
    std::vector<std::uint8_t> occluded(default_batch);
    for (std::size_t first = 0; first < stream.size(); first += default_batch) {
        const std::size_t count = std::min(default_batch, stream.size() - first);
        session.closest(stream.batch(first, count), hits);
        session.occluded(stream.batch(first, count), occluded);
        for (std::size_t i = 0; i < count; ++i) {
            add(digest, hits[i]);
            digest.add(occluded[i]);
        }
    }
}

}  // namespace

std::string hit_digest(const Catalogue& catalogue, const std::string& spec,
                       const std::vector<Case>& cases) {
    Digest digest;
    for (const Case& tested : cases) {
        digest.add(tested.name());
        const auto accel = build(catalogue, spec, tested.scene.input());
        const auto session = accel->open(Mode::timing);
        for (const Stream& stream : tested.streams) add_answers(digest, *session, stream);
    }
    return digest.hex();
}

std::string question_digest(const std::vector<Case>& cases) {
    Digest digest;
    for (const Case& tested : cases) {
        digest.add(tested.name());
        for (std::uint32_t i = 0; i < tested.scene.geometry.size(); ++i) {
            add(digest, tested.scene.geometry.bounds(i).lo);
            add(digest, tested.scene.geometry.bounds(i).hi);
        }
        for (const Stream& stream : tested.streams)
            for (const Ray& ray : stream.rays)
                if (finite(ray.origin) && finite(ray.direction)) add(digest, ray);
    }
    return digest.hex();
}

}  // namespace rayshoot::contract
