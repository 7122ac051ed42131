#pragma once

#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/lobe.h"

namespace rayshoot {

/// Glass: reflection and refraction by Fresnel's shares, at a smooth surface or at microfacets
/// (Walter et al. 2007). Radiance that comes out of the far medium is divided by index^2.
class Dielectric {
public:
    /// `tint` in [0, 1] scales what passes; `index` > 0 of the far medium / the near one;
    /// `roughness` in [0, 1] is alpha.
    Dielectric(const vec3& tint, float index, float roughness);

    vec3 evaluate(const vec3& out, const vec3& in) const;
    float pdf(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> sample(const vec3& out, float choice, Pair pair) const;
    bool only_deltas() const { return smooth_; }

private:
    LobeSample sample_smooth(const vec3& out, float choice) const;
    std::optional<LobeSample> reflect(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> refract(const vec3& out, const vec3& in) const;

    vec3 tint_;
    float index_;
    Ggx facets_;
    bool smooth_;
};
static_assert(Lobe<Dielectric>);

}  // namespace rayshoot
