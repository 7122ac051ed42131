#pragma once

#include "accel/bsp/layout.h"
#include "accel/space/outlines.h"

namespace rayshoot::inline RAYSHOOT_ISA {

static_assert(deepest_bsp + 2 <= Outlines::most_levels);

/// Round sub-trees, whose roots are the places.
Outlines outlined(const Geometry& geometry, const BspSketch& sketch, const BspTree& tree);

}  // namespace rayshoot::inline RAYSHOOT_ISA
