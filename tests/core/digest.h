#pragma once

#include <cstdint>

#include "accel/core/geometry.h"

/// One number for the bits of 10^5 hits: what every compiler and instruction set must agree on.
namespace rayshoot {

inline constexpr int digested_hits = 100000;

/// FNV-1a over t, u and v of the hits of seeded primitives of a kind, as the shared test gives
/// them.
std::uint64_t hit_digest(PrimitiveKind kind, Precision precision);

}  // namespace rayshoot
