#pragma once

#include "accel/core/primitive/test_ray.h"

#include <array>

/// Open cone or cylinder frustum, seen from both sides: NFF's cone and cylinder.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The lateral surface between two circles round the axis base-apex. Never hit when both ends
/// coincide or both radii are zero.
struct Frustum {
    vec3 base{0};
    float base_radius = 0;
    vec3 apex{0};
    float apex_radius = 0;

    bool operator==(const Frustum&) const = default;
};

/// The parameters at which an infinite line meets a surface.
struct Crossings {
    std::array<float, 2> t{};
    int count = 0;
};

/// In double, + - * / sqrt fma only; neither clamped nor sorted.
Crossings crossings(const Frustum& frustum, const vec3& origin, const vec3& direction);

/// Calls accept(t, u, v) for each crossing of the infinite line; u and v are 0.
template <class Accept>
inline void intersect(const Frustum& frustum, const TestRay& ray, Accept&& accept) {
    const Crossings found = crossings(frustum, ray.origin, ray.direction);
    for (int i = 0; i < found.count; ++i) accept(found.t[static_cast<std::size_t>(i)], 0.0f, 0.0f);
}

/// Of all that crossings() takes for the surface, rounded outward, not padded.
Box bounds(const Frustum& frustum);
/// Bounds of the part inside `box`; empty when there is none. Conservative.
Box clipped_bounds(const Frustum& frustum, const Box& box);
/// False only when the surface, grown by `radius`, misses the closed box. Conservative.
bool overlaps(const Frustum& frustum, const Box& box, float radius);
/// max over the surface's points x of dot(x, direction), rounded up.
float support(const Frustum& frustum, const vec3& direction);
/// Outward unit normal at a point of the surface (of the nearest one, for a point beside it).
vec3 normal_at(const Frustum& frustum, const vec3& point);

}  // namespace rayshoot::inline RAYSHOOT_ISA
