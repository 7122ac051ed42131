#pragma once

#include <optional>

#include "tracer/bsdf/ggx.h"

/// Refraction by microfacets that let everything pass (Walter et al. 2007); their users take off
/// Fresnel's share.
namespace rayshoot {

/// With less contrast than this the two media count as one: light passes straight on, and half
/// vectors, which are differences then, would be mostly rounding.
inline constexpr float smallest_contrast = 1e-3f;  // of the refraction index

struct FacetRefraction {
    float cosine = 0;  ///< of out with the facet
    float scattered =
        0;              ///< f |cos in|, for radiance: Walter's with the near medium's index squared
    float density = 0;  ///< per solid angle of `in`, when the facet is sampled as seen from out

    /// Shadowing of `in`, divided by index^2, by which radiance shrinks on its way to the near
    /// side.
    float weight() const { return scattered / density; }
};

/// Empty unless light from `in`, below the surface, can get to `out` by one facet. `index`: that of
/// the far medium / that of the near one. Masking is uncorrelated, G1(out) G1(in).
inline std::optional<FacetRefraction> facet_refraction(const Ggx& facets, float index,
                                                       const vec3& out, const vec3& in) {
    if (!(in.z < 0)) return std::nullopt;
    const vec3 sum = out + index * in;
    const float size = length(sum);
    if (!(size > 0)) return std::nullopt;
    const vec3 normal = sum / (sum.z < 0 ? -size : size);
    const float near = dot(out, normal), far = -dot(in, normal);
    if (!(near > 0 && far > 0)) return std::nullopt;
    const float visible = facets.visible_density(out, normal, near);
    const float spread = far / (size * size);  // |out + index in| is what Walter divides by
    return FacetRefraction{near, visible * facets.seen(in) * spread,
                           visible * index * index * spread};
}

}  // namespace rayshoot
