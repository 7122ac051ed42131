#pragma once

#include "accel/bvh/binary_tree.h"

#include <span>

namespace rayshoot::inline RAYSHOOT_ISA {

struct BinnedSah {
    static constexpr int most_bins = 256;

    int bins = 16;          ///< per axis, at most most_bins
    bool save_bins = true;  ///< where boxes are few
    std::uint32_t largest_leaf = 4;
    int deepest = 64;
    float step_cost = 1, test_cost = 1;  ///< of a node and of a test, in one unit
    std::uint32_t test_width = 1;        ///< boxes that one test tests at once; a power of two
};

/// Wald 2007: splits where the surface-area heuristic over centroid bins is least; in the middle of
/// the order where it finds no split (coincident centroids) or the depth would run out. In
/// parallel, and the same tree for any number of threads.
BinaryTree build_binned_sah(std::span<const Box> boxes, const BinnedSah& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
