#pragma once

#include "tracer/bsdf/bsdf.h"
#include "tracer/integrator/transport.h"
#include "tracer/light/lights.h"

namespace rayshoot {

/// The rendering equation (Kajiya 1986) by paths that end in chance: at each hit the light of one
/// source, chosen by its power, and one direction onward, both weighed by the power heuristic where
/// each could have found the other's light (Veach & Guibas 1995), and Russian roulette (Arvo & Kirk
/// 1990) from `roulette_level` on. What the depth cuts off is lost: the deeper, the less biased.
///
/// With a cache, where a ray of the camera or of mirrors meets a matt surface, what other surfaces
/// send to its Lambertian part is interpolated (Ward, Rubinstein & Clear 1988) wherever the cache
/// knows it; the path goes on for the other lobes alone.
class PathTracer final : public Integrator {
public:
    PathTracer(const Scene& scene, const TransportSettings& settings,
               const IrradianceCache* cache = nullptr);

    void shade(const Visit& visit, Sent& sent) const override;

private:
    struct Vertex;
    Vertex vertex_of(const Visit& visit, const SurfacePoint& point, const vec3& out) const;
    void emission(const Vertex& vertex, const Visit& visit, Sent& sent) const;
    void light(const Vertex& vertex, const Visit& visit, Sent& sent) const;
    void scatter(const Vertex& vertex, const Visit& visit, Sent& sent) const;

    const Scene& scene_;
    Lights lights_;
    TransportSettings settings_;
    const IrradianceCache* cache_;
};

}  // namespace rayshoot
