#pragma once

#include "accel/bvh/binary_tree.h"

namespace rayshoot::inline RAYSHOOT_ISA {

struct Reinsertion {
    int rounds = 2;
    int deepest = 64;  ///< a round that would make the tree deeper is taken back, and the last
};

/// Meister & Bittner 2018: takes sub-trees out and puts them where the sum of all boxes' areas
/// grows least. In parallel, and the same tree for any number of threads.
void reinsert(BinaryTree& tree, const Reinsertion& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
