#pragma once

#include "accel/bsp/sketch.h"
#include "accel/simd/packet.h"

/// What a packet's rays have still to visit.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A cell, which of the rays visit it, and each one's part inside.
struct BspPacketHalt {
    using Rows = std::array<float, Packet::most>;
    alignas(64) Rows entry, exit;
    RaySet rays = 0;
    std::uint32_t node = 0;
};

struct BspWalk {
    BspPacketHalt here;
    std::vector<BspPacketHalt> later = std::vector<BspPacketHalt>(deepest_bsp + 2);  ///< a stack
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
