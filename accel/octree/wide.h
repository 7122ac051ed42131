#pragma once

#include "accel/bvh8/layout.h"
#include "accel/octree/cell.h"

/// The octree in the nodes of the 8-wide hierarchy.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Children that hold nothing are left out, and each of the others has for its box the bounds of
/// what its leaves hold of their members: the part inside them, or if the octree is loose all of
/// each. Takes the members out of the cells.
WideTree<WideNode8> wide_octree(const Geometry& geometry, OctreeCell& root,
                                const Membership& membership, bool loose);

}  // namespace rayshoot::inline RAYSHOOT_ISA
