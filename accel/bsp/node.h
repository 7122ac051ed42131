#pragma once

#include "accel/simd/packed_leaves.h"

#include <bit>

/// Nodes of a BSP tree.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A plane and the place of two children that lie side by side, or a leaf; eight bytes.
class BspNode {
public:
    static constexpr std::uint32_t most_pairs = 1u << 27;

    BspNode() = default;
    /// Children: nodes 2 * pair, below the plane, and 2 * pair + 1, above it.
    /// `empty`: which of them are empty leaves, the lower one's bit first; so they need not be
    /// visited to be passed.
    static BspNode interior(int axis, float plane, std::uint32_t pair, std::uint32_t empty) {
        return {plane, pair << 4 | empty << 2 | static_cast<std::uint32_t>(axis)};
    }
    static BspNode leaf(PackedLeaf leaf) { return {0, leaf_bit | leaf.bits()}; }
    static BspNode empty_leaf() { return {0, empty_word}; }

    /// A leaf or an oblique node with a number, for those who keep something else of each.
    BspNode numbered(std::uint32_t number) const { return {std::bit_cast<float>(number), word_}; }
    std::uint32_t number() const { return std::bit_cast<std::uint32_t>(plane_); }

    bool is_leaf() const { return (word_ & leaf_bit) != 0; }
    bool is_empty() const { return word_ == empty_word; }
    PackedLeaf leaf() const { return PackedLeaf::from(word_ & ~leaf_bit); }
    /// 0, 1, 2; or oblique_axis, where the plane is that with the node's number.
    std::uint32_t axis() const { return word_ & 3; }
    float plane() const { return plane_; }
    /// 2 * pair
    std::uint32_t children() const { return word_ >> 4 << 1; }
    /// Whether a child, 0 or 1, is an empty leaf.
    bool empty_child(std::uint32_t side) const { return (word_ >> (2 + side) & 1) != 0; }

private:
    static constexpr std::uint32_t leaf_bit = 0x80000000, empty_word = 0xffffffff;
    BspNode(float plane, std::uint32_t word) : plane_(plane), word_(word) {}

    float plane_;
    std::uint32_t word_;
};
static_assert(sizeof(BspNode) == 8);

}  // namespace rayshoot::inline RAYSHOOT_ISA
