#pragma once

#include "accel/bvh/binned_sah.h"
#include "accel/bvh8/layout.h"

namespace rayshoot::inline RAYSHOOT_ISA {

/// HLBVH (../bvh/hlbvh.h) whose clusters are a wide node each, so that nearly all nodes and all
/// leaves are made in one pass over the sorted boxes. In parallel where all primitives are
/// triangles that stand still; the same for any number of threads. For each
/// type of node there is.
template <class Node>
WideTree<Node> build_wide_hlbvh(const Geometry& geometry, const BinnedSah& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
