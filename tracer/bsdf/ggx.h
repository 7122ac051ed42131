#pragma once

#include "accel/core/vec.h"
#include "tracer/sampling/pair.h"

namespace rayshoot {

/// Below this a surface counts as smooth: its lobe is narrower than 1/1000, and the half vector's
/// rounding would show.
inline constexpr float smallest_roughness = 1e-3f;

/// Isotropic microfacets with the distribution of Trowbridge & Reitz 1975, called GGX by Walter et
/// al. 2007, and Smith's masking. Local directions, z along the normal.
struct Ggx {
    float alpha = 1;  ///< in [smallest_roughness, 1]

    /// D: facets per solid angle and area, of a normal with z > 0.
    float density(const vec3& normal) const;
    /// Lambda of Smith's masking function; `direction` on either side, z != 0.
    float lambda(const vec3& direction) const;
    /// G1: the share of facets turned to `direction` that is seen from there.
    float seen(const vec3& direction) const { return 1 / (1 + lambda(direction)); }
    /// G2, of two directions on one side, correlated by height (Heitz 2014).
    float seen_from_both(const vec3& a, const vec3& b) const {
        return 1 / (1 + lambda(a) + lambda(b));
    }

    /// A normal with the density of those seen from `out`, out.z > 0 (Heitz 2018).
    vec3 visible_normal(const vec3& out, Pair pair) const;
    /// Its density per solid angle, for dot(out, normal) = cosine > 0.
    float visible_density(const vec3& out, const vec3& normal, float cosine) const {
        return seen(out) * density(normal) * cosine / out.z;
    }
};

}  // namespace rayshoot
