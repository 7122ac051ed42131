#pragma once

#include "accel/bsp/sketch.h"
#include "accel/space/membership.h"

/// Kaplan's tree.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Midpoint {
    int deepest = 16;                ///< levels; as in BES 2000
    std::uint32_t largest_leaf = 2;  ///< what has more primitives is divided; as in BES 2000
    std::uint64_t most_references = 0;
};

/// Cells are halved across x, y and z in turn (Kaplan 1985), while they hold too many primitives,
/// lie above the deepest level, and their share of the references allows it.
BspSketch build_midpoint(const Geometry& geometry, const Membership& membership,
                         const Midpoint& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
