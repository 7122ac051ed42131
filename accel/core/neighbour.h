#pragma once

#include "accel/core/isa.h"

#include <bit>
#include <cstdint>
#include <limits>

/// The floats next to a float: std::nextafter towards an infinity, but inlined.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The largest float below x; -infinity for itself. x is not NaN.
inline float float_below(float x) {
    if (x == 0) return -std::numeric_limits<float>::denorm_min();
    if (x == -std::numeric_limits<float>::infinity()) return x;
    const auto bits = std::bit_cast<std::uint32_t>(x);
    return std::bit_cast<float>(x > 0 ? bits - 1 : bits + 1);
}

/// The smallest float above x; +infinity for itself. x is not NaN.
inline float float_above(float x) { return -float_below(-x); }

}  // namespace rayshoot::inline RAYSHOOT_ISA
