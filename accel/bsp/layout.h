#pragma once

#include "accel/bsp/node.h"
#include "accel/bsp/sketch.h"
#include "accel/core/intersector.h"
#include "accel/core/raw_array.h"

/// From a builder's tree to nodes and packed leaves.
namespace rayshoot::inline RAYSHOOT_ISA {

struct BspTree {
    RawArray<BspNode> nodes;  ///< node 0 is the root, node 1 nothing; then pairs of children
    PackedLeaves leaves;
    Footprint footprint;
    std::vector<ObliquePlane> planes{};  ///< of oblique nodes
};

/// Depth first, so that a node and its left child are neighbours, and each part in a piece.
BspTree laid_out(const Geometry& geometry, const BspSketch& sketch);

}  // namespace rayshoot::inline RAYSHOOT_ISA
