#pragma once

#include "accel/core/box.h"

/// From a primitive's tight bounds to its stored ones: the box that its hits are clamped to.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Largest |coordinate| of a box.
inline float largest_coordinate(const Box& box) {
    float largest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float lo = std::abs(box.lo[axis]), hi = std::abs(box.hi[axis]);
        largest = lo > largest ? lo : largest;
        largest = hi > largest ? hi : largest;
    }
    return largest;
}

/// Share of the largest coordinate by which every box is padded: covers the rounding of a slab
/// parameter seen from nearby, (3 + 1 spare) * 2^-24.
inline constexpr float own_padding = 0x1p-22f;

/// `padding`: Geometry::padding(), the same for all primitives. The box must not be empty.
inline Box padded(const Box& tight, float padding) {
    return tight.grown(std::fma(own_padding, largest_coordinate(tight), padding));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
