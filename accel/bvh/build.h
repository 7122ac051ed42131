#pragma once

#include "accel/core/box.h"

#include <cstdint>
#include <span>
#include <vector>

/// Builders of binary hierarchies: boxes in, tree out. They know nothing of primitives or layouts.
namespace rayshoot::inline RAYSHOOT_ISA {

struct BinaryTree {
    struct Node {
        Box bounds;
        std::uint32_t first =
            0;  ///< leaf: place in `order`; interior: the left child, then the right
        std::uint32_t count = 0;  ///< primitives of a leaf; 0: interior
    };
    std::vector<Node> nodes;           ///< node 0 is the root; none for no boxes
    std::vector<std::uint32_t> order;  ///< box numbers, leaf after leaf
    int depth = 0;                     ///< of the deepest leaf; the root's is 0
};

struct BinnedSah {
    int bins = 16;
    std::uint32_t largest_leaf = 4;
    int deepest = 64;
    float step_cost = 1, test_cost = 1;  ///< of a node and of a test, in one unit
    std::uint32_t test_width = 1;        ///< primitives that one test tests at once
};

/// Wald 2007: splits where the surface-area heuristic over centroid bins is least; in the middle of
/// the order where it finds no split (coincident centroids) or the depth would run out.
BinaryTree build_binned_sah(std::span<const Box> boxes, const BinnedSah& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
