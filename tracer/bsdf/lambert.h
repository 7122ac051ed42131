#pragma once

#include "tracer/bsdf/lobe.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {

/// Alike in all directions: f = reflectance / pi.
class Lambert {
public:
    /// In [0, 1].
    explicit Lambert(const vec3& reflectance) : reflectance_(reflectance) {}

    vec3 evaluate(const vec3&, const vec3& in) const {
        return in.z > 0 ? reflectance_ * (in.z / pi) : vec3(0);
    }
    float pdf(const vec3&, const vec3& in) const { return cosine_hemisphere_pdf(in.z); }
    std::optional<LobeSample> sample(const vec3&, float, Pair pair) const {
        const vec3 in = cosine_hemisphere(pair);
        if (!(in.z > 0)) return std::nullopt;
        return LobeSample{in, reflectance_, cosine_hemisphere_pdf(in.z)};
    }
    bool only_deltas() const { return false; }
    const vec3& reflectance() const { return reflectance_; }

private:
    vec3 reflectance_;
};
static_assert(Lobe<Lambert>);

}  // namespace rayshoot
