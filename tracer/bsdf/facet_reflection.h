#pragma once

#include <optional>

#include "tracer/bsdf/ggx.h"
#include "tracer/bsdf/lobe.h"

/// Reflection by microfacets that reflect everything; their users add Fresnel's share.
namespace rayshoot {

struct FacetReflection {
    float cosine = 0;     ///< of out with the facet, and of in
    float scattered = 0;  ///< f |cos in| = D G2 / (4 cos out)
    float density = 0;    ///< per solid angle of `in`, when the facet is sampled as seen from out

    float weight() const { return scattered / density; }
};

/// Empty unless `in` is above the surface.
inline std::optional<FacetReflection> facet_reflection(const Ggx& facets, const vec3& out,
                                                       const vec3& in) {
    if (!(in.z > 0)) return std::nullopt;
    const vec3 normal = normalised(out + in);
    const float cosine = dot(out, normal);
    if (!(cosine > 0)) return std::nullopt;
    const float facing = facets.density(normal) / (4 * out.z);
    const float masked = facets.lambda(out);
    return FacetReflection{cosine, facing / (1 + masked + facets.lambda(in)),
                           facing / (1 + masked)};
}

/// `out` mirrored by a facet.
inline vec3 reflected(const vec3& out, const vec3& normal) {
    return normal * (2 * dot(out, normal)) - out;
}

}  // namespace rayshoot
