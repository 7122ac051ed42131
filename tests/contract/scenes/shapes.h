#pragma once

#include "accel/core/geometry.h"
#include "tests/contract/random.h"

#include <array>

/// Small shapes that several hard scenes are made of.
namespace rayshoot::contract {

inline void add_quad(GeometryBuilder& builder, const vec3& corner, const vec3& u, const vec3& v,
                     std::uint32_t motion = no_motion) {
    builder.add_triangle(corner, corner + u, corner + u + v, motion);
    builder.add_triangle(corner, corner + u + v, corner + v, motion);
}

/// Twelve triangles, closed.
inline void add_cube(GeometryBuilder& builder, const vec3& lo, const vec3& hi,
                     std::uint32_t motion = no_motion) {
    const vec3 x(hi.x - lo.x, 0, 0), y(0, hi.y - lo.y, 0), z(0, 0, hi.z - lo.z);
    add_quad(builder, lo, y, x, motion);
    add_quad(builder, lo + z, x, y, motion);
    add_quad(builder, lo, x, z, motion);
    add_quad(builder, lo + y, z, x, motion);
    add_quad(builder, lo, z, y, motion);
    add_quad(builder, lo + x, y, z, motion);
}

/// `count` triangles with a corner in `box` and edges up to `length` along each axis.
inline void add_soup(GeometryBuilder& builder, Random& random, const Box& box, float length,
                     int count, std::uint32_t motion = no_motion) {
    const Box edge{vec3(-length), vec3(length)};
    for (int i = 0; i < count; ++i) {
        const vec3 a = random.inside(box);
        const vec3 b = a + random.inside(edge);
        const vec3 c = a + random.inside(edge);
        builder.add_triangle(a, b, c, motion);
    }
}

/// Points of the unit circle with rational coordinates: no trigonometry, the same everywhere.
/// `share` in [0, 4) runs once round, a quarter for each unit.
inline std::array<float, 2> circle(float share) {
    const int quarter = static_cast<int>(share);
    const float s = share - static_cast<float>(quarter);
    const float w = 1 + s * s, x = (1 - s * s) / w, y = 2 * s / w;
    switch (quarter & 3) {
        case 0:
            return {x, y};
        case 1:
            return {-y, x};
        case 2:
            return {-x, -y};
        default:
            return {y, -x};
    }
}

}  // namespace rayshoot::contract
