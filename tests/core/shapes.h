#pragma once

#include <gtest/gtest.h>

#include "accel/core/primitive/extent.h"
#include "tests/core/cases.h"

/// The four kinds as one list of types, for tests that ask the same of each.
namespace rayshoot::cases {

template <class Shape>
Shape make(Random& random) {
    if constexpr (std::is_same_v<Shape, Triangle>) return triangle(random);
    if constexpr (std::is_same_v<Shape, Sphere>) return sphere(random);
    if constexpr (std::is_same_v<Shape, Frustum>) return frustum(random);
    if constexpr (std::is_same_v<Shape, Polygon>) return polygon(random);
}

using Shapes = testing::Types<Triangle, Sphere, Frustum, Polygon>;

/// Distance outside of a box, 0 inside.
inline double outside(const Box& box, const dvec3& p) {
    double worst = 0;
    for (int axis = 0; axis < 3; ++axis)
        worst = std::max({worst, double(box.lo[axis]) - p[axis], p[axis] - double(box.hi[axis])});
    return worst;
}

/// Spots are computed in double: how far one may be from the surface it should be on.
inline double spot_error(const Box& whole) {
    return 0x1p-46 * (length(dvec3(whole.lo)) + length(dvec3(whole.hi)));
}

/// A box round or beside a point of the surface.
inline Box box_near(const dvec3& point, double size, Random& random) {
    Box box;
    const vec3 centre(point);
    const double half = size * random.magnitude(-6, 0);
    box.include(centre + random.in_cube(half));
    box.include(centre + random.in_cube(half));
    return box;
}

}  // namespace rayshoot::cases
