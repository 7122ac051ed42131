#pragma once

#include "accel/octree/cell.h"

/// Where to cut a cell of an octree.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Along each axis by itself: of ten positions, evenly spaced from the middle of the cell to the
/// median of its members' centres, the one with the least
/// (members below or across) * (area below) + (members above or across) * (area above).
std::array<float, 3> sah_planes(const OctreeCell& cell, const Membership& membership);

}  // namespace rayshoot::inline RAYSHOOT_ISA
