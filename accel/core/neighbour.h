#pragma once

#include "accel/core/isa.h"

#include <bit>
#include <cstdint>
#include <limits>

/// The floats next to a float: std::nextafter towards an infinity, but inlined.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The largest float below x; -infinity for itself. x is not NaN.
inline float float_below(float x) {
    constexpr std::uint32_t negative = 0x80000000, minus_infinity = 0xff800000;
    const auto bits = std::bit_cast<std::uint32_t>(x);
    // Selections, not branches: signs cannot be foretold.
    std::uint32_t below = bits - 1 + 2 * (bits >> 31);
    below = (bits & ~negative) == 0 ? negative + 1 : below;
    return std::bit_cast<float>(bits == minus_infinity ? bits : below);
}

/// The smallest float above x; +infinity for itself. x is not NaN.
inline float float_above(float x) { return -float_below(-x); }

}  // namespace rayshoot::inline RAYSHOOT_ISA
