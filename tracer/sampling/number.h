#pragma once

#include <cstdint>

namespace rayshoot {

/// From 32 random bits, or 32 binary digits with the first one highest, to [0, 1): a multiple of
/// 2^-24, rounded down.
constexpr float unit_number(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

}  // namespace rayshoot
