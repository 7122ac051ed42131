#include "tests/contract/case.h"

#include "tests/contract/truth.h"

#include <algorithm>
#include <cstdio>

namespace rayshoot::contract {
namespace {

constexpr std::size_t fewest_per_family = 24, most_per_family = 60;
constexpr std::size_t dead_ray_spacing = 61;  // camera rays; a prime, so that it drifts in packets

std::vector<RayFamily> families() {
    std::vector<RayFamily> all;
    for (const auto& some : {aimed_families(), axis_families(), remote_families()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

std::size_t rays_per_family(const Geometry& geometry, const Settings& settings) {
    const std::uint64_t affordable =
        settings.tests_per_scene / (std::max(geometry.size(), 1u) * families().size());
    return std::clamp<std::size_t>(affordable, fewest_per_family, most_per_family);
}

void append(Stream& stream, const std::vector<Ray>& rays, std::string_view family) {
    stream.rays.insert(stream.rays.end(), rays.begin(), rays.end());
    stream.families.insert(stream.families.end(), rays.size(), family);
}

/// Fisher & Yates' shuffle: std::shuffle is not the same everywhere.
void shuffle(Stream& stream, Random& random) {
    for (std::size_t left = stream.size(); left > 1; --left) {
        const std::size_t other = random.below(static_cast<std::uint32_t>(left));
        std::swap(stream.rays[left - 1], stream.rays[other]);
        std::swap(stream.families[left - 1], stream.families[other]);
        std::swap(stream.truth[left - 1], stream.truth[other]);
    }
}

/// All families, the same with limits at their hits, and the invalid ones among them.
Stream hard_stream(const Geometry& geometry, std::size_t per_family, Random& random) {
    Stream stream{.name = "hard rays"};
    for (const RayFamily& family : families()) {
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < per_family; ++i) rays.push_back(family.make(geometry, random));
        append(stream, rays, family.name);
    }
    answer_truly(geometry, stream);
    append(stream, limited_rays(stream.rays, stream.truth, random, 6 * per_family), "limited");
    append(stream, invalid_rays(), "invalid");
    answer_truly(geometry, stream);
    shuffle(stream, random);
    return stream;
}

/// Coherent, with a dead ray now and then.
Stream camera_stream(const HardScene& scene, Random& random) {
    SourcedRays made = camera_rays(scene.view, random);
    for (std::size_t i = 0; i < made.rays.size(); i += dead_ray_spacing)
        made.rays[i].t_max = -infinity;
    Stream stream{
        "camera rays", RayKind::camera, std::move(made.rays), std::move(made.source), {}, {}};
    stream.families.assign(stream.size(), "camera");
    answer_truly(scene.geometry, stream);
    return stream;
}

Stream shadow_stream(const HardScene& scene, std::size_t count, Random& random) {
    SourcedRays made = shadow_rays(scene, random, count);
    Stream stream{
        "shadow rays", RayKind::shadow, std::move(made.rays), std::move(made.source), {}, {}};
    stream.families.assign(stream.size(), "shadow");
    answer_truly(scene.geometry, stream);
    return stream;
}

/// The same rays asked as another kind, with nothing promised.
Stream without_promise(const Stream& stream, RayKind kind, std::string name, std::size_t at_most) {
    Stream part = stream;
    const std::size_t count = std::min(stream.size(), at_most);
    part.name = std::move(name);
    part.kind = kind;
    part.source.clear();
    part.rays.resize(count);
    part.families.resize(count);
    part.truth.resize(count);
    return part;
}

}  // namespace

RayBatch Stream::batch(std::size_t first, std::size_t count) const {
    const std::span<const Source> promised(source);
    return {kind, 1, std::span(rays).subspan(first, count),
            source.empty() ? promised : promised.subspan(first, count)};
}

std::string Case::name() const {
    char text[32];
    std::snprintf(text, sizeof text, "%#llx", static_cast<unsigned long long>(seed));
    const bool watertight = scene.geometry.precision() == Precision::watertight;
    return scene.name + ", precision " + (watertight ? "watertight" : "default") + ", seed " + text;
}

Stream repeated(const Stream& stream, std::size_t size) {
    Stream longer = stream;
    for (std::size_t i = stream.size(); i < size; ++i) {
        const std::size_t k = i % stream.size();
        longer.rays.push_back(stream.rays[k]);
        longer.families.push_back(stream.families[k]);
        longer.truth.push_back(stream.truth[k]);
        if (!stream.source.empty()) longer.source.push_back(stream.source[k]);
    }
    return longer;
}

void answer_truly(const Geometry& geometry, Stream& stream) {
    const Truth truth(geometry);
    for (std::size_t i = stream.truth.size(); i < stream.size(); ++i)
        stream.truth.push_back(truth.closest(stream.rays[i]));
}

Case make_case(const Recipe& recipe, Precision precision, const Settings& settings) {
    Case made{hard_scene(recipe, precision), settings.seed, {}};
    Random random(settings.seed);
    const std::size_t per_family = rays_per_family(made.scene.geometry, settings);
    const Stream hard = hard_stream(made.scene.geometry, per_family, random);
    made.streams.push_back(hard);
    made.streams.push_back(camera_stream(made.scene, random));
    made.streams.push_back(shadow_stream(made.scene, 6 * per_family + 5, random));
    for (const auto& [kind, name] : {std::pair(RayKind::camera, "hard rays asked as camera rays"),
                                     std::pair(RayKind::shadow, "hard rays asked as shadow rays")})
        made.streams.push_back(without_promise(hard, kind, name, 6 * per_family));
    return made;
}

std::vector<Case> make_cases(const Settings& settings) {
    std::vector<Case> cases;
    for (const Recipe& recipe : hard_scenes()) {
        const bool wanted = settings.scenes.empty() ||
                            std::count(settings.scenes.begin(), settings.scenes.end(), recipe.name);
        if (!wanted) continue;
        cases.push_back(make_case(recipe, Precision::standard, settings));
        if (!cases.back().scene.geometry.triangles().empty())
            cases.push_back(make_case(recipe, Precision::watertight, settings));
    }
    return cases;
}

}  // namespace rayshoot::contract
