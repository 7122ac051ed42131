#include "tracer/integrator/irradiance_fill.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tracer/integrator/path_tracer.h"
#include "tracer/sampling/warp.h"
#include "tracer/tiles.h"
#include "tracer/wavefront.h"

namespace rayshoot {
namespace {

constexpr int coarsest_lattice = 16;  ///< cells between looks at first; halved down to 1
/// Records made side by side: enough for a few lanes, few enough that one often spares another.
constexpr std::size_t chunk = 64;
/// A record is good for this many pixels at least, and for this share of the scene at most.
constexpr float least_pixels = 2, most_of_scene = 0.1f;
/// Light of lamps comes from samples of them, at the record's place: a gathered ray that meets one
/// had no chance, as the power heuristic sees it.
constexpr float no_chance = std::numeric_limits<float>::min();
constexpr std::uint32_t gather_seed = 0x19880801;  ///< apart from the image's own numbers

/// A matt point that the camera sees.
struct Place {
    SurfacePoint point;
    vec3 normal;  ///< on the side that is seen
    float time = 0;
    Pixel pixel;
    float pixel_size = 0;  ///< scene units, there
};

/// Pixels of a lattice that are in no coarser one, in the order of the image's tiles.
std::vector<Pixel> lattice(const std::vector<Pixel>& pixels, int spacing) {
    std::vector<Pixel> members;
    const auto on = [](Pixel pixel, int step) {
        return pixel.x % step == 0 && pixel.y % step == 0;
    };
    for (const Pixel pixel : pixels) {
        const bool earlier = spacing < coarsest_lattice && on(pixel, 2 * spacing);
        if (on(pixel, spacing) && !earlier) members.push_back(pixel);
    }
    return members;
}

/// What one lane needs.
struct Gatherer {
    std::unique_ptr<Session> session;
    Wavefront wavefront;
    std::vector<Shot> shots;
};

class Filling {
public:
    Filling(const Scene& scene, const Accel& accel, const CameraRays& camera,
            const TransportSettings& settings, std::size_t batch)
        : scene_(scene),
          camera_(camera),
          settings_(settings),
          cache_(settings.cache_error),
          paths_(scene, settings),
          sampler_({.kind = SamplerKind::jitter,
                    .spp = settings.gather,
                    .seed = camera.format().seed ^ gather_seed}),
          eye_(accel.open(Mode::timing)),
          gatherers_([this, &accel, batch] {
              std::unique_ptr<Session> session = accel.open(Mode::timing);
              Session& opened = *session;
              return Gatherer{
                  std::move(session), Wavefront(paths_, opened, scene_.lights.size(), batch), {}};
          }) {}

    IrradianceCache fill() && {
        const ImageFormat& format = camera_.format();
        const std::vector<Pixel> pixels = morton_order(format.width, format.height);
        for (int spacing = coarsest_lattice; spacing >= 1; spacing /= 2) {
            const std::vector<Place> places = seen(lattice(pixels, spacing));
            for (std::size_t first = 0; first < places.size(); first += chunk) {
                const std::size_t count = std::min(chunk, places.size() - first);
                add(std::span(places).subspan(first, count));
            }
        }
        return std::move(cache_);
    }

private:
    std::vector<Place> seen(const std::vector<Pixel>& pixels);
    std::optional<Place> place(Pixel pixel, const Ray& ray, const Hit& hit) const;
    bool covered(const Place& place) const {
        return cache_.irradiance(vec3(place.point.position), place.normal).has_value();
    }
    void add(std::span<const Place> places);
    IrradianceRecord gathered(const Place& place, Gatherer& gatherer) const;

    const Scene& scene_;
    const CameraRays& camera_;
    TransportSettings settings_;
    IrradianceCache cache_;
    PathTracer paths_;
    Sampler sampler_;
    std::unique_ptr<Session> eye_;
    tbb::enumerable_thread_specific<Gatherer> gatherers_;
};

std::vector<Place> Filling::seen(const std::vector<Pixel>& pixels) {
    std::vector<Place> places;
    std::vector<Ray> rays;
    std::vector<Source> sources;
    std::vector<Hit> hits(default_batch);
    for (std::size_t first = 0; first < pixels.size(); first += default_batch) {
        const std::size_t count = std::min(default_batch, pixels.size() - first);
        rays.clear();
        sources.clear();
        for (const Pixel pixel : std::span(pixels).subspan(first, count)) {
            rays.push_back(camera_.ray(pixel.x + 0.5, pixel.y + 0.5, {0.5f, 0.5f}, 0.5f));
            sources.push_back(CameraRays::source(pixel));
        }
        eye_->closest({RayKind::camera, 1, rays, sources}, std::span(hits).first(count));
        for (std::size_t i = 0; i < count; ++i) {
            if (auto found = place(pixels[first + i], rays[i], hits[i])) places.push_back(*found);
        }
    }
    return places;
}

std::optional<Place> Filling::place(Pixel pixel, const Ray& ray, const Hit& hit) const {
    if (hit.primitive == no_primitive) return std::nullopt;
    const SurfacePoint point = surface_point(scene_.geometry, ray, hit);
    const Bsdf bsdf(scene_.material(hit.primitive), point, -normalised(ray.direction));
    if (bsdf.diffuse_reflectance() == vec3(0)) return std::nullopt;
    const float distance = hit.t * length(ray.direction);
    return Place{point, bsdf.normal(), ray.time, pixel, distance * length(camera_.view().across)};
}

void Filling::add(std::span<const Place> places) {
    std::vector<std::optional<IrradianceRecord>> records(places.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        if (!covered(places[i])) records[i] = gathered(places[i], gatherers_.local());
    });
    for (std::size_t i = 0; i < places.size(); ++i)
        if (records[i] && !covered(places[i])) cache_.insert(*records[i]);
}

/// pi times the mean radiance over directions distributed with the cosine.
IrradianceRecord Filling::gathered(const Place& place, Gatherer& gatherer) const {
    const Frame frame(place.normal);
    std::vector<Shot>& shots = gatherer.shots;
    shots.clear();
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(settings_.gather); ++i) {
        const Pair pair = sampler_.pair(place.pixel, i, {Use::pixel});
        Shot shot;
        shot.ray.direction = frame.to_world(cosine_hemisphere(pair));
        shot.ray.origin = spawn_origin(place.point, shot.ray.direction);
        shot.ray.time = place.time;
        shot.sampler = &sampler_;
        shot.pixel = place.pixel;
        shot.sample = i;
        shots.push_back(shot);
    }
    gatherer.wavefront.trace(shots, 2, no_chance);
    vec3 sum(0);
    double inverses = 0;
    for (const Shot& shot : shots) {
        sum += shot.radiance;
        inverses += 1 / double{shot.distance};  // nothing hit: 0
    }
    const auto count = static_cast<float>(shots.size());
    const float diagonal = length(scene_.geometry.bounds().size());
    const float least = least_pixels * place.pixel_size / settings_.cache_error;
    const float most = std::max(least, most_of_scene * diagonal / settings_.cache_error);
    const auto mean = static_cast<float>(static_cast<double>(count) / inverses);
    return {vec3(place.point.position), place.normal, sum * (std::numbers::pi_v<float> / count),
            std::clamp(mean, least, most)};
}

}  // namespace

IrradianceCache fill_irradiance_cache(const Scene& scene, const Accel& accel,
                                      const CameraRays& camera, const TransportSettings& settings,
                                      std::size_t batch, int threads) {
    tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
    return arena.execute([&] { return Filling(scene, accel, camera, settings, batch).fill(); });
}

}  // namespace rayshoot
