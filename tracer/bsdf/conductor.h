#pragma once

#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/lobe.h"

namespace rayshoot {

/// Metal: a smooth mirror, or microfacets (Cook & Torrance 1982 with the GGX distribution): f = F D
/// G2 / (4 cos out cos in), F of the complex refraction index. Light that facets reflect to one
/// another is lost (README.md says how much).
class Conductor {
public:
    /// `tint` in [0, 1] scales F; `roughness` in [0, 1] is alpha.
    Conductor(const vec3& tint, const vec3& eta, const vec3& absorption, float roughness);

    vec3 evaluate(const vec3& out, const vec3& in) const;
    float pdf(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> sample(const vec3& out, float choice, Pair pair) const;
    bool only_deltas() const { return smooth_; }

private:
    vec3 reflectance(float cosine) const;

    vec3 tint_, eta_, absorption_;
    Ggx facets_;
    bool smooth_;
};
static_assert(Lobe<Conductor>);

}  // namespace rayshoot
