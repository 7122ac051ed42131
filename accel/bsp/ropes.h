#pragma once

#include "accel/bsp/layout.h"

/// From each leaf to what lies behind its faces (Havran, Bittner & Zara 1998; Popov, Guenther,
/// Seidel & Slusallek 2007).
namespace rayshoot::inline RAYSHOOT_ISA {

struct RopedLeaf {
    static constexpr std::uint32_t outside = 0xffffffff;

    Box box;
    /// The smallest sub-tree behind the whole face: lo.x, lo.y, lo.z, hi.x, hi.y, hi.z.
    std::array<std::uint32_t, 6> ropes;
};

/// Of each leaf; numbers the leaves of the tree.
std::vector<RopedLeaf> roped_leaves(BspTree& tree, const Box& space);

}  // namespace rayshoot::inline RAYSHOOT_ISA
