#pragma once

#include "accel/core/ray.h"

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/camera.h"
#include "tracer/ray_counts.h"
#include "tracer/sampling/sampler.h"

/// What light comes back along a ray: the part of the tracer that methods differ in. It sees hits
/// and sends rays; `Wavefront` does the tracing.
namespace rayshoot {

/// One camera sample: the ray of a pixel that is traced, and what it brings.
struct Shot {
    Ray ray;
    Source source;
    const Sampler* sampler = nullptr;  ///< of its random numbers, never null
    Pixel pixel;
    std::uint32_t sample = 0;   ///< its number among those of the sampler
    vec3 radiance{0};           ///< out: linear RGB
    float distance = infinity;  ///< out: t of the first hit

    float number(Dimension of) const { return sampler->number(pixel, sample, of); }
    Pair pair(Dimension of) const { return sampler->pair(pixel, sample, of); }
};

/// What is left to know of a ray when its hit comes back.
struct Path {
    std::uint32_t shot = 0;   ///< which of the tile's
    std::uint32_t place = 1;  ///< in the shot's tree of rays: names its random numbers (Dimension)
    Cause cause = Cause::camera;
    vec3 throughput{1};  ///< its share of the shot's radiance
    float pdf = 0;       ///< per solid angle, of its direction; 0: it was not drawn from a density
    vec3 back{0};        ///< from the ray's start, beside the surface, to the point it was drawn at
};

/// A ray with its hit, which may be a miss.
struct Visit {
    const Ray& ray;
    const Hit& hit;
    const Path& path;
    const Shot& shot;
    int depth = 1;  ///< level in the tree of rays; 1 is the camera's

    Dimension dimension(Use use) const { return {use, path.place}; }
    float number(Use use) const { return number(dimension(use)); }
    Pair pair(Use use) const { return pair(dimension(use)); }
    float number(Dimension of) const { return shot.number(of); }
    Pair pair(Dimension of) const { return shot.pair(of); }
};

/// What the hits of a wave send on.
struct Sent {
    struct Rays {
        std::vector<Ray> rays;
        std::vector<Path> paths;
    };
    /// Light that arrives if nothing is in between.
    struct Arriving {
        vec3 radiance;
        std::uint32_t shot = 0;
    };
    /// Rays to one light, and what arrives along each.
    struct Shadows {
        std::vector<Ray> rays;
        std::vector<Arriving> arriving;
    };

    std::span<Shot> shots;
    Rays reflections, refractions;
    std::vector<Shadows> shadows;  ///< one per light
    std::uint64_t totally_reflected = 0;

    void radiance(const Path& to, const vec3& arriving) {
        shots[to.shot].radiance += arriving * to.throughput;
    }
    /// `arriving`: at the eye of `to`'s ray, if the light is seen.
    void shadow(std::uint32_t light, const Ray& ray, const Path& to, const vec3& arriving) {
        append(ray, shadows[light].rays);
        append({arriving * to.throughput, to.shot}, shadows[light].arriving);
    }
    void ray(const Ray& ray, const Path& path) {
        Rays& rays = path.cause == Cause::reflection ? reflections : refractions;
        append(ray, rays.rays);
        append(path, rays.paths);
    }

private:
    /// A push_back takes an address: what was just computed would go through memory in small
    /// pieces, to be read again in large ones, which processors wait for.
    template <class Value>
    [[gnu::always_inline]] static void append(const Value& value, std::vector<Value>& to) {
        to.emplace_back() = value;
    }
};

/// Immutable and shared by all lanes. What it sends depends on the visit alone.
class Integrator {
public:
    virtual ~Integrator() = default;

    /// Adds the light that the visit's point sends back by itself, and sends the rays that bring
    /// the rest; none to the next level when `visit.depth` is its last.
    virtual void shade(const Visit& visit, Sent& sent) const = 0;
};

}  // namespace rayshoot
