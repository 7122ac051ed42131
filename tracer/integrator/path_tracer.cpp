#include "tracer/integrator/path_tracer.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numbers>

namespace rayshoot {
namespace {

/// A path is followed at least with this probability's complement of being ended: so that none goes
/// on for ever between surfaces that absorb nothing.
constexpr float most_survival = 0.95f;

/// Power heuristic of Veach & Guibas 1995, for one sample of each strategy.
float power_heuristic(float pdf, float other) {
    const float ratio = other / pdf;
    return 1 / (1 + ratio * ratio);
}

/// part / all in each channel, 0 of nothing.
vec3 share(const vec3& part, const vec3& all) {
    const auto quotient = [](float a, float b) { return b > 0 ? a / b : 0.0f; };
    return {quotient(part.x, all.x), quotient(part.y, all.y), quotient(part.z, all.z)};
}

}  // namespace

struct PathTracer::Vertex {
    SurfacePoint point;
    vec3 out;  ///< unit, to where the ray came from
    Bsdf bsdf;
    /// Irradiance that need not be followed up, where the cache knows it, and what becomes of it.
    std::optional<vec3> cached = std::nullopt;
    vec3 reflectance{0};

    /// The share of f |cos in| that the cached irradiance stands for.
    vec3 matt(const vec3& in, const vec3& all) const {
        if (!cached) return vec3(0);
        const float cosine = std::max(0.0f, dot(bsdf.normal(), in));
        return glm::min(all, reflectance * (cosine * std::numbers::inv_pi_v<float>));
    }
};

PathTracer::PathTracer(const Scene& scene, const TransportSettings& settings,
                       const IrradianceCache* cache)
    : scene_(scene), lights_(scene), settings_(settings), cache_(cache) {
    for (const Material& material : scene.materials) require_physical(material);
}

void PathTracer::shade(const Visit& visit, Sent& sent) const {
    if (visit.hit.primitive == no_primitive) {
        sent.radiance(visit.path, scene_.background);
        return;
    }
    const SurfacePoint point = surface_point(scene_.geometry, visit.ray, visit.hit);
    const vec3 out = -normalised(visit.ray.direction);
    const Vertex vertex = vertex_of(visit, point, out);
    emission(vertex, visit, sent);
    if (visit.depth == levels(settings_)) return;
    if (vertex.cached) {
        sent.radiance(visit.path,
                      vertex.reflectance * *vertex.cached * std::numbers::inv_pi_v<float>);
    }
    light(vertex, visit, sent);
    scatter(vertex, visit, sent);
}

PathTracer::Vertex PathTracer::vertex_of(const Visit& visit, const SurfacePoint& point,
                                         const vec3& out) const {
    Vertex vertex{point, out, Bsdf(scene_.material(visit.hit.primitive), point, out)};
    const bool seen_sharply = visit.path.pdf == 0;
    if (!cache_ || !seen_sharply) return vertex;
    vertex.reflectance = vertex.bsdf.diffuse_reflectance();
    if (vertex.reflectance != vec3(0))
        vertex.cached = cache_->irradiance(vec3(point.position), vertex.bsdf.normal());
    return vertex;
}

/// What the surface sends by itself; less where the level before might have aimed at it.
void PathTracer::emission(const Vertex& vertex, const Visit& visit, Sent& sent) const {
    const std::uint32_t primitive = visit.hit.primitive;
    vec3 radiance = lights_.emitted(primitive, vertex.point, vertex.out);
    if (radiance == vec3(0)) return;
    const std::uint32_t light = lights_.light_of(primitive);
    if (visit.path.pdf > 0 && light != no_light) {
        const float aimed = lights_.probability(light) *
                            lights_.pdf(light, dvec3(visit.ray.origin) + dvec3(visit.path.back),
                                        vertex.point, visit.ray.time);
        radiance = radiance * power_heuristic(visit.path.pdf, aimed);
    }
    sent.radiance(visit.path, radiance);
}

void PathTracer::light(const Vertex& vertex, const Visit& visit, Sent& sent) const {
    if (vertex.bsdf.only_deltas()) return;
    const Lights::Choice choice = lights_.choose(visit.number(Use::light_choice));
    if (choice.light == no_light) return;
    const auto sample =
        lights_.sample(choice.light, vertex.point.position, visit.ray.time, visit.pair(Use::light));
    if (!sample) return;
    vec3 reflected = vertex.bsdf.evaluate(sample->direction);
    if (reflected == vec3(0)) return;
    const bool could_be_met = !scene_.lights[choice.light].primitives.empty();
    if (sample->pdf > 0 && could_be_met) {
        const float met = vertex.bsdf.pdf(sample->direction);
        const vec3 matt = vertex.matt(sample->direction, reflected);
        reflected =
            matt + (reflected - matt) * power_heuristic(sample->pdf * choice.probability, met);
    }
    sent.shadow(choice.light, shadow_ray(vertex.point, *sample, visit.ray.time), visit.path,
                reflected * sample->incident / choice.probability);
}

void PathTracer::scatter(const Vertex& vertex, const Visit& visit, Sent& sent) const {
    const auto sample = vertex.bsdf.sample(visit.number(Use::lobe_choice), visit.pair(Use::lobe));
    if (!sample) return;
    Path path = visit.path;
    path.throughput = path.throughput * sample->weight;
    if (vertex.cached && !sample->delta) {
        const vec3 all = vertex.bsdf.evaluate(sample->in);
        path.throughput = path.throughput * share(all - vertex.matt(sample->in, all), all);
    }
    path.pdf = sample->delta ? 0 : sample->pdf;
    path.place = visit.dimension(Use::lobe).child(0).place;
    if (visit.depth >= settings_.roulette_level) {
        const float survival = std::min(most_survival, largest(path.throughput));
        if (!(visit.number(Use::roulette) < survival)) return;
        path.throughput = path.throughput / survival;
    }
    if (path.throughput == vec3(0)) return;
    const bool through =
        dot(sample->in, vertex.point.geometric) * dot(vertex.out, vertex.point.geometric) < 0;
    path.cause = through ? Cause::refraction : Cause::reflection;
    Ray ray;
    ray.origin = spawn_origin(vertex.point, sample->in);
    ray.direction = sample->in;
    ray.time = visit.ray.time;
    path.back = vec3(vertex.point.position - dvec3(ray.origin));
    sent.ray(ray, path);
}

}  // namespace rayshoot
