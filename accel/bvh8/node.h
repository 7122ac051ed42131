#pragma once

#include "accel/core/box.h"

/// Nodes of the 8-wide tree, and what their children are.
namespace rayshoot::inline RAYSHOOT_ISA {

/// An interior node's number, or a leaf, in one word.
class WideChild {
public:
    static constexpr std::uint32_t most_blocks = 8;  ///< of triangles, in a leaf

    static WideChild node(std::uint32_t number) { return WideChild(number); }
    /// Blocks `first` .. `first + count` of triangles.
    static WideChild blocks(std::uint32_t first, std::uint32_t count) {
        return WideChild(leaf_bit | first * most_blocks | (count - 1));
    }
    /// Whatever else, by its number among the mixed leaves.
    static WideChild mixed(std::uint32_t number) {
        return WideChild(leaf_bit | mixed_bit | number);
    }
    /// Lies at the bottom of every stack, and is no child.
    static WideChild none() { return WideChild(none_bits); }
    static WideChild from(std::uint32_t bits) { return WideChild(bits); }

    std::uint32_t bits() const { return bits_; }
    bool interior() const { return (bits_ & leaf_bit) == 0; }
    bool is_mixed() const { return (bits_ & mixed_bit) != 0; }
    bool is_none() const { return bits_ == none_bits; }
    std::uint32_t number() const { return bits_ & ~(leaf_bit | mixed_bit); }
    std::uint32_t first_block() const { return number() / most_blocks; }
    std::uint32_t block_count() const { return bits_ % most_blocks + 1; }

private:
    static constexpr std::uint32_t leaf_bit = 0x80000000, mixed_bit = 0x40000000,
                                   none_bits = 0xffffffff;
    explicit WideChild(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

/// Four cache lines: the bounds of eight children, plane by plane, and what they are.
struct alignas(64) WideNode {
    static constexpr std::size_t width = 8;

    Boxes<width> bounds;                          ///< empty where there is no child
    std::array<std::uint32_t, width> children{};  ///< bits of a WideChild each
    std::uint32_t live = 0;                       ///< children that exist, the first ones

    WideChild child(std::size_t i) const { return WideChild::from(children[i]); }
};
static_assert(sizeof(WideNode) == 256);

}  // namespace rayshoot::inline RAYSHOOT_ISA
