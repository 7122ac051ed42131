#pragma once

#include <optional>

#include "data/scene.h"
#include "tracer/light/clearance.h"
#include "tracer/sampling/pair.h"

namespace rayshoot {

/// A sphere that shines outwards and inwards, sampled uniformly by solid angle: over the cone that
/// it fills as seen from outside (Shirley, Wang & Zimmerman 1996), over all directions from inside.
class SphereEmitter {
public:
    SphereEmitter(const Scene& scene, const Light& light);

    std::optional<LightSample> sample(const dvec3& from, float time, Pair pair) const;
    float pdf(const dvec3& from, const SurfacePoint& at, float time) const;
    vec3 power(double) const;

private:
    /// What fills its solid angle, seen along `axis`, from a point to the centre.
    struct Aspect {
        double height;  ///< 1 - cos of the cone of directions that meet it; 2: all
        bool far_end;   ///< the light's point is where a direction leaves the sphere
    };
    Aspect aspect(const dvec3& from, const dvec3& centre) const;
    dvec3 centre(float time) const;

    const Light& light_;
    const Motion* motion_ = nullptr;  ///< null: it rests
    Clearance clearance_;
};

}  // namespace rayshoot
