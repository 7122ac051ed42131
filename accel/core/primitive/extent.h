#pragma once

#include "accel/core/primitive/sphere.h"
#include "accel/core/primitive/triangle.h"

/// What builders ask of triangles and spheres beyond their bounds; frusta and polygons declare the
/// same with themselves.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Bounds of the part inside `box`, rounded outward; empty when there is none.
Box clipped_bounds(const Triangle& triangle, const Box& box);
Box clipped_bounds(const Sphere& sphere, const Box& box);

/// False only when no point within `radius` of the surface is in the closed box: for triangles by
/// the separating axis test (Akenine-Moeller 2001), for spheres by the nearest and farthest point.
bool overlaps(const Triangle& triangle, const Box& box, float radius);
bool overlaps(const Sphere& sphere, const Box& box, float radius);

/// max over the surface's points x of dot(x, direction), rounded up.
float support(const Triangle& triangle, const vec3& direction);
float support(const Sphere& sphere, const vec3& direction);

inline vec3 unit_or_up(const dvec3& direction) {
    const double size = length(direction);
    return size > 0 ? vec3(direction / size) : vec3(0, 0, 1);
}

/// Unit normals; (0, 0, 1) where the shape has none.
inline vec3 geometric_normal(const Triangle& triangle) {
    const dvec3 a(triangle.a);
    return unit_or_up(cross(dvec3(triangle.b) - a, dvec3(triangle.c) - a));
}
inline vec3 normal_at(const Sphere& sphere, const vec3& point) {
    return unit_or_up(dvec3(point) - dvec3(sphere.centre));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
