#include "tracer/wavefront.h"

#include <algorithm>

namespace rayshoot {

RayCount RayCounts::of(RayKind kind) const {
    const RayCounts& all = *this;
    if (kind == RayKind::camera) return all[Cause::camera];
    if (kind == RayKind::shadow) return all[Cause::shadow];
    return {all[Cause::reflection].rays + all[Cause::refraction].rays,
            all[Cause::reflection].hits + all[Cause::refraction].hits};
}

RayCounts& RayCounts::operator+=(const RayCounts& other) {
    for (std::size_t i = 0; i < by_cause.size(); ++i) {
        by_cause[i].rays += other.by_cause[i].rays;
        by_cause[i].hits += other.by_cause[i].hits;
    }
    totally_reflected += other.totally_reflected;
    return *this;
}

void Wavefront::Wave::clear() {
    rays.clear();
    paths.clear();
    sources.clear();
}

void Wavefront::Wave::append(const Wave& other) {
    rays.insert(rays.end(), other.rays.begin(), other.rays.end());
    paths.insert(paths.end(), other.paths.begin(), other.paths.end());
}

void Wavefront::Shadows::clear() {
    rays.clear();
    sources.clear();
    pixels.clear();
    radiances.clear();
}

Wavefront::Wavefront(const Scene& scene, const CameraRays& camera,
                     const WavefrontSettings& settings, Session& session, Image& image)
    : scene_(scene),
      camera_(camera),
      settings_(settings),
      session_(session),
      image_(image),
      shadows_(scene.lights.size()),
      hits_(settings.batch),
      occluded_(settings.batch) {}

void Wavefront::trace(std::span<const Pixel> tile) {
    start(tile);
    for (int depth = 1; !wave_.rays.empty(); ++depth) {
        reflections_.clear();
        refractions_.clear();
        for (std::size_t first = 0; first < wave_.rays.size(); first += settings_.batch) {
            trace_batch(first, std::min(settings_.batch, wave_.rays.size() - first), depth);
        }
        // Rays of one kind stay together: they are the more coherent.
        wave_.clear();
        wave_.append(reflections_);
        wave_.append(refractions_);
    }
    const float share = 1.0f / static_cast<float>(camera_.format().spp);
    for (const Pixel pixel : tile) image_.at(pixel.x, pixel.y) *= share;
}

void Wavefront::start(std::span<const Pixel> tile) {
    wave_.clear();
    for (const Pixel pixel : tile) {
        for (int sample = 0; sample < camera_.format().spp; ++sample) {
            wave_.rays.push_back(camera_.ray(pixel, sample));
            wave_.sources.push_back(CameraRays::source(pixel));
            wave_.paths.push_back({pixel, Cause::camera, 1});
        }
    }
}

void Wavefront::trace_batch(std::size_t first, std::size_t count, int depth) {
    RayBatch batch;
    batch.kind = depth == 1 ? RayKind::camera : RayKind::secondary;
    batch.depth = static_cast<std::uint8_t>(depth);
    batch.rays = std::span(wave_.rays).subspan(first, count);
    if (depth == 1) batch.source = std::span(wave_.sources).subspan(first, count);
    session_.closest(batch, std::span(hits_).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        shade(wave_.paths[first + i], batch.rays[i], hits_[i], depth);
    }
    for (Shadows& shadows : shadows_) trace_shadows(shadows, depth);
}

void Wavefront::shade(const Path& path, const Ray& ray, const Hit& hit, int depth) {
    RayCount& count = counts_[path.cause];
    ++count.rays;
    vec3& pixel = image_.at(path.pixel.x, path.pixel.y);
    if (hit.primitive == no_primitive) {
        pixel += scene_.background * path.weight;
        return;
    }
    ++count.hits;
    const Shade shade = make_shade(scene_, settings_.rules, ray, hit);
    pixel += ambient(scene_, *shade.material) * path.weight;
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light) {
        const auto sample = illumination(shade, scene_.lights[light]);
        if (!sample) continue;
        Shadows& shadows = shadows_[light];
        shadows.rays.push_back(sample->ray);
        shadows.sources.push_back(Source::light(light));
        shadows.pixels.push_back(path.pixel);
        shadows.radiances.push_back(sample->radiance * path.weight);
    }
    if (depth < settings_.depth) spawn(shade, path);
}

void Wavefront::spawn(const Shade& shade, const Path& path) {
    const Spawned spawned = spawned_rays(shade);
    const auto add = [&](const SpawnedRay& ray, Cause cause, Wave& to) {
        to.rays.push_back(ray.ray);
        to.paths.push_back({path.pixel, cause, path.weight * ray.weight});
    };
    if (spawned.reflection) add(*spawned.reflection, Cause::reflection, reflections_);
    if (spawned.refraction) add(*spawned.refraction, Cause::refraction, refractions_);
    counts_.totally_reflected += spawned.totally_reflected;
}

void Wavefront::trace_shadows(Shadows& shadows, int depth) {
    const std::size_t count = shadows.rays.size();  // at most one per ray of a batch
    if (count == 0) return;
    const auto occluded = std::span(occluded_).first(count);
    session_.occluded(
        {RayKind::shadow, static_cast<std::uint8_t>(depth), shadows.rays, shadows.sources},
        occluded);
    RayCount& shadow_count = counts_[Cause::shadow];
    shadow_count.rays += count;
    for (std::size_t i = 0; i < count; ++i) {
        shadow_count.hits += occluded[i];
        if (occluded[i]) continue;
        image_.at(shadows.pixels[i].x, shadows.pixels[i].y) += shadows.radiances[i];
    }
    shadows.clear();
}

}  // namespace rayshoot
