#include "tests/yardsticks/oracle.h"

#include "accel/core/leaves.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace rayshoot::yardsticks {
namespace {

/// Our own test of every primitive, in order.
class BruteForce {
public:
    explicit BruteForce(const Geometry& geometry) : all_{0, geometry.size()} {
        std::vector<std::uint32_t> order(geometry.size());
        std::iota(order.begin(), order.end(), 0u);
        leaves_ = Leaves(geometry, order, std::span(&all_, 1));
    }
    Hit closest(const Ray& ray) const {
        if (!answerable(ray)) return {};
        Hit hit = nothing_yet(ray);
        const Silent count;
        leaves_.test<Query::closest>(all_, leaves_.prepared(ray), hit, count);
        return hit.primitive == no_primitive ? Hit{} : hit;
    }

private:
    LeafRange all_;
    Leaves leaves_;
};

std::string text(const Ray& ray) {
    char line[256];
    std::snprintf(line, sizeof line, "{{%a,%a,%a},%a,{%a,%a,%a},%a,%a}", ray.origin.x, ray.origin.y,
                  ray.origin.z, ray.t_min, ray.direction.x, ray.direction.y, ray.direction.z,
                  ray.t_max, ray.time);
    return line;
}

bool alike(const Hit& a, const Hit& b, float tolerance) {
    const bool hit = a.primitive != no_primitive;
    if (hit != (b.primitive != no_primitive)) return false;
    return !hit ||
           std::abs(a.t - b.t) <= tolerance * std::max({std::abs(a.t), std::abs(b.t), 1.0f});
}

bool ambiguous(const BruteForce& brute_force, const Ray& ray, const Hit& hit, float size,
               float tolerance) {
    const float shift = tolerance * std::max(taxicab(ray.origin), size);
    for (int corner = 0; corner < 8; ++corner) {
        Ray beside = ray;
        for (int axis = 0; axis < 3; ++axis)
            beside.origin[axis] += (corner >> axis & 1) != 0 ? shift : -shift;
        if (!alike(brute_force.closest(beside), hit, 8 * tolerance)) return true;
    }
    return false;
}

}  // namespace

std::vector<Hit> closest(const Accel& accel, const std::vector<Ray>& rays, RayKind kind,
                         std::size_t batch) {
    const std::unique_ptr<Session> session = accel.open(Mode::timing);
    std::vector<Hit> hits(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += batch) {
        const std::size_t count = std::min(batch, rays.size() - first);
        session->closest({kind, 1, std::span(rays).subspan(first, count), {}},
                         std::span(hits).subspan(first, count));
    }
    return hits;
}

std::vector<std::uint8_t> occluded(const Accel& accel, const std::vector<Ray>& rays, RayKind kind,
                                   std::size_t batch) {
    const std::unique_ptr<Session> session = accel.open(Mode::timing);
    std::vector<std::uint8_t> answers(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += batch) {
        const std::size_t count = std::min(batch, rays.size() - first);
        session->occluded({kind, 1, std::span(rays).subspan(first, count), {}},
                          std::span(answers).subspan(first, count));
    }
    return answers;
}

Comparison compare(const Geometry& geometry, const std::vector<Ray>& rays,
                   const std::vector<Hit>& answers, float tolerance) {
    const BruteForce brute_force(geometry);
    const float size = taxicab(geometry.bounds().size());
    Comparison comparison;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit hit = brute_force.closest(rays[i]);
        ++comparison.rays;
        comparison.hits += hit.primitive != no_primitive;
        if (alike(hit, answers[i], tolerance)) continue;
        if (ambiguous(brute_force, rays[i], hit, size, tolerance)) {
            ++comparison.ambiguous;
            continue;
        }
        if (comparison.differences++ == 0) {
            char line[160];
            std::snprintf(line, sizeof line, ": brute force %a at %u, here %a at %u", hit.t,
                          hit.primitive, answers[i].t, answers[i].primitive);
            comparison.first = text(rays[i]) + line;
        }
    }
    return comparison;
}

}  // namespace rayshoot::yardsticks
