#include "tracer/recorder.h"

#include <algorithm>
#include <stdexcept>

#include "tracer/camera_samples.h"
#include "tracer/integrator/transport.h"
#include "tracer/random.h"
#include "tracer/surface.h"
#include "tracer/tiles.h"
#include "tracer/wavefront.h"

namespace rayshoot {
namespace {

void append(const RayBatch& batch, RecordedRays& to) {
    to.rays.insert(to.rays.end(), batch.rays.begin(), batch.rays.end());
    to.sources.insert(to.sources.end(), batch.source.begin(), batch.source.end());
}

/// Dimensions of a sample's random numbers; the first two jitter the camera ray.
constexpr std::uint32_t bounce_dimension = 16, chord_dimension = 512, chord_end_dimension = 1024;

/// Uniform in the unit sphere's surface: by rejection, so that no libm is in it.
vec3 unit_vector(const RandomSequence& random, std::uint32_t dimension) {
    constexpr std::uint32_t tries = 64;  // each succeeds with pi / 6: all fail in 1 of 10^20
    for (std::uint32_t i = 0; i < tries; ++i, dimension += 3) {
        const vec3 point(2 * random.number(dimension) - 1, 2 * random.number(dimension + 1) - 1,
                         2 * random.number(dimension + 2) - 1);
        const float squared = dot(point, point);
        if (squared <= 1 && squared > 0x1p-20f) return point / std::sqrt(squared);
    }
    return {0, 0, 1};
}

/// Passes everything on and keeps the rays, and the hits of camera rays.
class RecordingSession final : public Session {
public:
    RecordingSession(Session& session, RecordedStreams& streams)
        : session_(session), streams_(streams) {}

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        append(batch, batch.kind == RayKind::camera ? streams_.camera : streams_.secondary);
        if (batch.kind != RayKind::camera) {
            // Recorded, not followed: what it would hit belongs to no stream.
            std::ranges::fill(hits, Hit{});
            return {};
        }
        const auto declined = session_.closest(batch, hits);
        camera_hits_.insert(camera_hits_.end(), hits.begin(), hits.end());
        return declined;
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        append(batch, streams_.shadow);
        std::ranges::fill(occluded, std::uint8_t{1});
        return {};
    }
    const Counters* counters(RayKind) const override { return nullptr; }
    const std::vector<Hit>& camera_hits() const { return camera_hits_; }

private:
    Session& session_;
    RecordedStreams& streams_;
    std::vector<Hit> camera_hits_;
};

/// To the side the camera ray came from, distributed with the cosine to the geometric normal: a
/// uniform point on the sphere that touches the surface (so again without libm).
Ray diffuse_bounce(const Scene& scene, const Ray& ray, const Hit& hit,
                   const RandomSequence& random) {
    const SurfacePoint point = surface_point(scene.geometry, ray, hit);
    const vec3 normal =
        dot(point.geometric, ray.direction) > 0 ? -point.geometric : point.geometric;
    const vec3 direction = normal + unit_vector(random, bounce_dimension);
    Ray bounce;
    bounce.direction = dot(direction, direction) > 0x1p-20f ? normalised(direction) : normal;
    bounce.origin = spawn_origin(point, bounce.direction);
    bounce.time = ray.time;
    return bounce;
}

Ray chord(const Box& bounds, const RandomSequence& random) {
    const float radius = 0.5f * length(bounds.size());
    Ray ray;
    ray.origin = bounds.centre() + radius * unit_vector(random, chord_dimension);
    ray.direction =
        bounds.centre() + radius * unit_vector(random, chord_end_dimension) - ray.origin;
    return ray;
}

/// What a tile's camera rays spawn, without antialiasing filters, lens settings of one's own or a
/// film.
void trace_camera_rays(const Scene& scene, const ImageFormat& format, Session& session) {
    TransportSettings transport;
    transport.depth = 2;  // the second level is only recorded
    const CameraRays camera(scene.camera, format);
    const Filter box;
    const CameraSamples camera_samples(camera, box, Reconstruction::importance, shutter_of(scene));
    const Sampler sampler({.spp = format.spp, .seed = format.seed});
    const auto integrator = make_integrator(scene, transport);
    Wavefront wavefront(*integrator, session, scene.lights.size(), default_batch);
    const Tiles tiles(format, default_batch);
    std::vector<Shot> shots;
    std::vector<FilmSample> on_film;
    for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
        shots.clear();
        on_film.clear();
        for (const Pixel pixel : tiles.tile(tile))
            camera_samples.sample(sampler, pixel, shots, on_film);
        wavefront.trace(shots);
    }
}

}  // namespace

RecordedStreams record_streams(const Scene& scene, const Accel& accel, const ImageFormat& format) {
    if (!accel.complete()) {
        throw std::invalid_argument("'" + accel.spec() +
                                    "' answers only some rays; record with a complete structure");
    }
    RecordedStreams streams;
    const std::unique_ptr<Session> session = accel.open(Mode::timing);
    RecordingSession recording(*session, streams);
    trace_camera_rays(scene, format, recording);

    for (std::size_t i = 0; i < streams.camera.rays.size(); ++i) {
        const RandomSequence random(format.seed, static_cast<std::uint32_t>(i), 0);
        const Hit& hit = recording.camera_hits()[i];
        const Ray& ray = streams.camera.rays[i];
        if (hit.primitive != no_primitive) {
            streams.diffuse.rays.push_back(diffuse_bounce(scene, ray, hit, random));
        }
    }
    streams.random.rays =
        random_chords(scene.geometry.bounds(), streams.camera.rays.size(), format.seed);
    return streams;
}

std::vector<Ray> random_chords(const Box& bounds, std::size_t count, std::uint32_t seed) {
    std::vector<Ray> rays;
    if (bounds.empty()) return rays;
    rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        rays.push_back(chord(bounds, RandomSequence(seed, static_cast<std::uint32_t>(i), 0)));
    }
    return rays;
}

}  // namespace rayshoot
