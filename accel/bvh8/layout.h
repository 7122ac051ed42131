#pragma once

#include "accel/bvh/binary_tree.h"
#include "accel/bvh8/node.h"
#include "accel/core/raw_array.h"

/// From a binary tree to wide nodes and packed leaves.
namespace rayshoot::inline RAYSHOOT_ISA {

template <class Node>
struct WideTree {
    RawArray<Node> nodes;  ///< the root first, even when there is nothing in it
    PackedLeaves leaves;
    std::uint32_t leaf_count = 0;
    int depth = 0;  ///< of the deepest leaf, in levels of the binary tree it was made from
};

/// Nodes and leaves stand depth first, but for the topmost nodes, which come before all others. In
/// parallel where all primitives are triangles that stand still; the same for any number of
/// threads. For each type of node there is.
template <class Node>
WideTree<Node> laid_out(const Geometry& geometry, const BinaryTree& tree);

}  // namespace rayshoot::inline RAYSHOOT_ISA
