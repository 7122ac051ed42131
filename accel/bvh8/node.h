#pragma once

#include "accel/core/box.h"
#include "accel/simd/triangle_block.h"

/// Nodes of the 8-wide tree, and what their children are.
namespace rayshoot::inline RAYSHOOT_ISA {

/// An interior node or a leaf, in one word: where it lies, in units of 32 bytes from the first node
/// or the first block.
class WideChild {
public:
    static constexpr std::size_t unit = 32;
    static constexpr std::uint32_t most_blocks = 8;         ///< of triangles, in a leaf
    static constexpr std::uint32_t most_units = 1u << 27;  ///< 4 GiB of nodes, and of blocks

    static WideChild node(std::uint32_t number);
    /// Blocks `first` .. `first + count` of triangles.
    static WideChild blocks(std::uint32_t first, std::uint32_t count);
    /// Whatever else, by its number among the mixed leaves.
    static WideChild mixed(std::uint32_t number) {
        return WideChild(leaf_bit | mixed_bit | number);
    }
    /// Lies at the bottom of every stack, and is no child.
    static constexpr WideChild none() { return WideChild(0xffffffff); }
    static WideChild from(std::uint32_t bits) { return WideChild(bits); }

    std::uint32_t bits() const { return bits_; }
    bool interior() const { return (bits_ & leaf_bit) == 0; }
    bool is_mixed() const { return (bits_ & mixed_bit) != 0; }
    bool is_none() const { return bits_ == none().bits_; }
    std::uint32_t mixed_number() const { return bits_ & ~(leaf_bit | mixed_bit); }
    /// Bytes from the first node, or from the first block.
    std::size_t offset() const { return std::size_t{bits_ & (most_units - 1)} * unit; }
    std::uint32_t block_count() const { return (bits_ / most_units) % most_blocks + 1; }
    /// Of a leaf of several blocks: the others.
    WideChild after_first() const;

private:
    static constexpr std::uint32_t leaf_bit = 0x80000000, mixed_bit = 0x40000000;
    constexpr explicit WideChild(std::uint32_t bits) : bits_(bits) {}
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
static_assert(sizeof(WideNode) == 256 && sizeof(TriangleBlock) % WideChild::unit == 0);

inline WideChild WideChild::node(std::uint32_t number) {
    return WideChild(number * static_cast<std::uint32_t>(sizeof(WideNode) / unit));
}
inline WideChild WideChild::blocks(std::uint32_t first, std::uint32_t count) {
    constexpr auto units = static_cast<std::uint32_t>(sizeof(TriangleBlock) / unit);
    return WideChild(leaf_bit | (count - 1) * most_units | first * units);
}
inline WideChild WideChild::after_first() const {
    constexpr auto units = static_cast<std::uint32_t>(sizeof(TriangleBlock) / unit);
    return WideChild(bits_ + units - most_units);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
