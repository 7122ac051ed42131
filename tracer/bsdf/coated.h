#pragma once

#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/lobe.h"

namespace rayshoot {

/// A diffuser below a rough dielectric coat: s F D G2 / (4 cos out cos in) + (1 - s F(out)) (1 - s
/// F(in)) reflectance / pi. Cook & Torrance 1982 add the two with constant shares; here Fresnel
/// divides between them, on the way in and on the way out, so the sum is reciprocal and below 1.
class CoatedDiffuser {
public:
    /// `reflectance` and `specular` (s) in [0, 1]; `index` > 0 of the coat; `roughness` is alpha.
    CoatedDiffuser(const vec3& reflectance, float specular, float index, float roughness);

    vec3 evaluate(const vec3& out, const vec3& in) const;
    float pdf(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> sample(const vec3& out, float choice, Pair pair) const;
    bool only_deltas() const { return false; }

private:
    /// s F.
    float coat(float cosine) const;
    float coat_probability(float coat_share) const;
    vec3 diffuse(const vec3& out, const vec3& in) const;

    vec3 reflectance_;
    float specular_, index_;
    Ggx facets_;
    bool smooth_;
};
static_assert(Lobe<CoatedDiffuser>);

}  // namespace rayshoot
