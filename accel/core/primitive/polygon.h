#pragma once

#include "accel/core/primitive/test_ray.h"

#include <optional>
#include <span>
#include <vector>

/// Planar polygon, concave allowed, seen from both sides.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The set of points of `plane` whose projection along `axis` is inside the projected corners by
/// the even-odd rule. Corners a little off the plane, as printed numbers are, thereby define a set
/// in the plane all the same: their flattened() places. Made by make_polygon only.
struct Polygon {
    std::vector<vec3> corners;
    std::vector<vec3> normals;  ///< empty, or one per corner
    dvec3 centre{0};            ///< average of the corners: a point of the plane
    dvec3 normal{0};  ///< Newell's: right-handed, as long as twice the area; zero: never hit
    int axis = 2;     ///< in which |normal| is largest: dropped by the inside test
};

/// Throws std::invalid_argument for fewer than 3 corners or another number of normals than of
/// corners; a polygon without area is accepted and never hit.
Polygon make_polygon(std::span<const vec3> corners, std::span<const vec3> normals);

/// Rays with |dot(normal, direction)| at most this share of the taxicab lengths' product count as
/// parallel: about the rounding error of that dot product.
inline constexpr double parallel_polygon = 0x1p-48;

/// Where an infinite line meets the polygon, in double, + - * / fma only.
std::optional<float> crossing(const Polygon& polygon, const vec3& origin, const vec3& direction);

/// Calls accept(t, u, v) for the crossing of the infinite line, if any; u and v are 0.
template <class Accept>
inline void intersect(const Polygon& polygon, const TestRay& ray, Accept&& accept) {
    if (const auto t = crossing(polygon, ray.origin, ray.direction)) accept(*t, 0.0f, 0.0f);
}

/// Corner moved along `axis` into the plane.
dvec3 flattened(const Polygon& polygon, const vec3& corner);

/// Tight, rounded outward, not padded.
Box bounds(const Polygon& polygon);
/// Bounds of the part inside `box`; empty when there is none. Conservative where concave.
Box clipped_bounds(const Polygon& polygon, const Box& box);
/// False only when the polygon, grown by `radius`, misses the closed box. Conservative.
bool overlaps(const Polygon& polygon, const Box& box, float radius);
/// max over the polygon's points x of dot(x, direction), rounded up.
float support(const Polygon& polygon, const vec3& direction);
/// Unit normal by winding.
vec3 geometric_normal(const Polygon& polygon);
/// Mean of the corners' normals by generalised barycentrics, or the geometric normal without any.
vec3 shading_normal(const Polygon& polygon, const vec3& point);

}  // namespace rayshoot::inline RAYSHOOT_ISA
