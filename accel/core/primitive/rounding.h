#pragma once

#include "accel/core/neighbour.h"

/// From double to the float next to it on the side that is asked for.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The largest float that is not above x; x is not NaN.
inline float rounded_down(double x) {
    const float near = static_cast<float>(x);
    return near > x ? float_below(near) : near;
}

/// The smallest float that is not below x; x is not NaN.
inline float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace rayshoot::inline RAYSHOOT_ISA
