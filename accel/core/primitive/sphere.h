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

/// Calls accept(t, 0, 0) for both roots of the ray's line; t is NaN where a root does not exist.
template <class Accept>
inline void intersect(const Sphere& sphere, const TestRay& ray, Accept&& accept) {
    const vec3 from_centre = ray.origin - sphere.centre;
    // Squares of squares stay in range, and the distance is known well against the radius.
    const float distance = taxicab(from_centre);
    const bool in_range = distance < 0x1p20f * sphere.radius && sphere.radius > 0x1p-25f &&
                          distance < 0x1p25f && ray.direction_size > 0x1p-25f &&
                          ray.direction_size < 0x1p25f;
    if (in_range) [[likely]]
        return intersect_sphere<float>(from_centre, sphere.radius, ray.direction, accept);
    intersect_sphere<double>(dvec3(ray.origin) - dvec3(sphere.centre), sphere.radius,
                             dvec3(ray.direction), accept);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
