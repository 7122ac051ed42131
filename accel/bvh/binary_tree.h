#pragma once

#include "accel/core/box.h"
#include "accel/core/raw_array.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>

/// What the builders of hierarchies make: boxes in, tree out. They know nothing of layouts.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Children stand side by side, the left one at an even place. With n boxes there are 2n places,
/// of which leaves of several boxes leave some unused and unwritten: walk down from the root.
struct BinaryTree {
    struct Node {
        Box bounds;
        std::uint32_t first;  ///< leaf: place in `order`; interior: the left child, then the right
        std::uint32_t count;  ///< boxes of a leaf; 0: interior
    };
    static constexpr std::uint32_t root = 0;  ///< alone in its pair

    RawArray<Node> nodes;           ///< none for no boxes
    RawArray<std::uint32_t> order;  ///< box numbers; those of a leaf together, ascending
    std::uint32_t leaves = 0;
    int depth = 0;  ///< of the deepest leaf; the root's is 0

    BinaryTree() = default;
    /// Throws std::length_error for more than most_boxes.
    explicit BinaryTree(std::size_t boxes)
        : nodes(2 * checked(boxes), PageUse::sparse), order(boxes) {}
    static constexpr std::size_t most_boxes = std::size_t{1} << 31;  ///< places have 32 bits

    /// The boxes before and after place `middle` of the order are parted nowhere else, so the place
    /// of the pair that parts them needs no counter, and is free whatever else is built meanwhile.
    static std::uint32_t pair_at(std::uint32_t middle) { return 2 * middle; }
    /// From here on a sub-tree over the boxes from place `first` on may put its pairs side by side.
    static std::uint32_t pairs_from(std::uint32_t first) { return pair_at(first) + 2; }
    static std::uint32_t sibling(std::uint32_t node) { return node ^ 1; }

private:
    static std::size_t checked(std::size_t boxes) {
        if (boxes > most_boxes) throw std::length_error("a binary tree over more than 2^31 boxes");
        return boxes;
    }
};

/// Of a sub-tree.
struct Extent {
    std::uint32_t leaves = 0;
    int depth = 0;

    static Extent of_leaf(int depth) { return {1, depth}; }
    Extent operator+(const Extent& other) const {
        return {leaves + other.leaves, std::max(depth, other.depth)};
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
