#pragma once

#include "accel/core/isa.h"

#include <cmath>
#include <limits>

/// From double to the float next to it on the side that is asked for.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The largest float that is not above x.
inline float rounded_down(double x) {
    const float near = static_cast<float>(x);
    return near > x ? std::nextafter(near, -std::numeric_limits<float>::infinity()) : near;
}

/// The smallest float that is not below x.
inline float rounded_up(double x) { return -rounded_down(-x); }

}  // namespace rayshoot::inline RAYSHOOT_ISA
