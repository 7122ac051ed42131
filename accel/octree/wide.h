#pragma once

#include "accel/bvh8/layout.h"
#include "accel/octree/cell.h"
#include "accel/space/outlines.h"

/// The octree in the nodes of the 8-wide hierarchy.
namespace rayshoot::inline RAYSHOOT_ISA {

struct WideOctree {
    WideTree<WideNode8> tree;
    OutlinedRuns outlines;  ///< of nodes, with overlap=exact
};

/// Children that hold nothing are left out, and each of the others has for its box the bounds of
/// what its leaves hold of their members: the part inside them, or if the octree is loose all of
/// each. Takes the members out of the cells.
WideOctree wide_octree(const Geometry& geometry, OctreeCell& root, const Membership& membership,
                       bool loose);

}  // namespace rayshoot::inline RAYSHOOT_ISA
