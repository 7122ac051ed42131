#pragma once

#include "accel/core/primitive/test_ray.h"

/// The sphere: two-sided, both roots are hits.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Sphere {
    vec3 centre{0};
    float radius = 0;  ///< >= 0
};

inline Box bounds(const Sphere& sphere) {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lo[axis] = sphere.centre[axis] - sphere.radius;
        box.hi[axis] = sphere.centre[axis] + sphere.radius;
    }
    return box;
}

/// Haines, Gunther & Akenine-Moeller 2019: the discriminant from the line's distance to the centre,
/// the roots without cancellation.
template <std::floating_point F, class Accept>
inline void intersect_sphere(const vec<F>& from_centre, F radius, const vec<F>& direction,
                             Accept&& accept) {
    const F a = dot(direction, direction);
    const F b = -dot(from_centre, direction);
    const vec<F> nearest = along(from_centre, b / a, direction);
    const F discriminant = std::fma(radius, radius, -dot(nearest, nearest));
    if (!(discriminant >= 0)) return;
    const F q = b + std::copysign(std::sqrt(a * discriminant), b);
    const F c = std::fma(-radius, radius, dot(from_centre, from_centre));
    accept(static_cast<float>(c / q), 0.0f, 0.0f);
    accept(static_cast<float>(q / a), 0.0f, 0.0f);
}

/// Float is taken where squares of squares stay in range, and where the distance is known well
/// against the radius: between these lengths, and at most so many radii away.
inline constexpr float shortest_float_length = 0x1p-25f, longest_float_length = 0x1p25f;
inline constexpr float most_float_radii = 0x1p20f;

/// Calls accept(t, 0, 0) for both roots of the ray's line; t is NaN where a root does not exist.
template <class Accept>
inline void intersect(const Sphere& sphere, const TestRay& ray, Accept&& accept) {
    const vec3 from_centre = ray.origin - sphere.centre;
    const float distance = taxicab(from_centre);
    const bool in_range =
        distance < most_float_radii * sphere.radius && sphere.radius > shortest_float_length &&
        distance < longest_float_length && ray.direction_size > shortest_float_length &&
        ray.direction_size < longest_float_length;
    if (in_range) [[likely]]
        return intersect_sphere<float>(from_centre, sphere.radius, ray.direction, accept);
    intersect_sphere<double>(dvec3(ray.origin) - dvec3(sphere.centre), sphere.radius,
                             dvec3(ray.direction), accept);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
