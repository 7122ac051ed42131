#pragma once

#include "accel/core/geometry.h"

/// Where rays that leave a surface start: no absolute epsilon anywhere.
namespace rayshoot {

/// The point of the primitive that a ray hit.
struct SurfacePoint {
    dvec3 position{0};        ///< on the primitive, far better than a float can tell
    vec3 geometric{0, 0, 1};  ///< unit normal, as stored
    vec3 shading{0, 0, 1};    ///< unit normal, as stored
    double error = 0;         ///< scene units along the normal; see surface_point
};

/// `hit` must be a hit of `ray`. `position` is not origin + t * direction, whose error grows with
/// the distance travelled, but the point of the primitive that the hit names; `error` bounds how
/// far the primitive's own test may place a point of it off the surface, for a ray that starts
/// beside it, and how far behind the surface that should have been hit it may lie (README.md
/// derives both).
SurfacePoint surface_point(const Geometry& geometry, const Ray& ray, const Hit& hit);

/// The part of that error that is the primitive's own, wherever the point, for rays that start
/// beside it: without that of distances and of the point's rounding.
double resting_error(const Geometry& geometry, std::uint32_t primitive);

/// A float point on the side of the surface that `direction` leaves to, so far off it that no test
/// finds the surface at t > 0 again.
inline vec3 spawn_origin(const SurfacePoint& point, const vec3& direction) {
    const double side = dot(point.geometric, direction) < 0 ? -point.error : point.error;
    return vec3(point.position + dvec3(point.geometric) * side);
}

}  // namespace rayshoot
