#pragma once

#include <optional>

#include "accel/core/build_input.h"
#include "tracer/light/light_sample.h"
#include "tracer/sampling/pair.h"

namespace rayshoot {

/// A light without extent: point, spot or directional.
class PointEmitter {
public:
    explicit PointEmitter(const Light& light) : light_(light) {}

    std::optional<LightSample> sample(const dvec3& from, float time, Pair pair) const;
    /// No ray can meet it.
    float pdf(const dvec3&, const SurfacePoint&, float) const { return 0; }
    /// Watts per channel, for a scene of this radius; without falloff, what arrives there.
    vec3 power(double scene_radius) const;

private:
    /// Of the intensity, in a direction from the light of that cosine with its axis.
    double spot_share(double cosine) const;

    const Light& light_;
};

}  // namespace rayshoot
