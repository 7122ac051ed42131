#pragma once

#include "accel/core/box.h"
#include "accel/simd/packed_leaves.h"

/// Nodes of the 8-wide tree, and what their children are.
namespace rayshoot::inline RAYSHOOT_ISA {

/// An interior node's number, or a leaf, in one word.
class WideChild {
public:
    static constexpr std::uint32_t most_nodes = 0x7fffffff;

    static WideChild node(std::uint32_t number) { return WideChild(number); }
    static WideChild leaf(PackedLeaf leaf) { return WideChild(leaf_bit | leaf.bits()); }
    /// Lies at the bottom of every stack, and is no child.
    static constexpr WideChild none() { return WideChild(0xffffffff); }
    static WideChild from(std::uint32_t bits) { return WideChild(bits); }

    std::uint32_t bits() const { return bits_; }
    bool interior() const { return (bits_ & leaf_bit) == 0; }
    bool is_none() const { return bits_ == none().bits_; }
    std::uint32_t number() const { return bits_ & ~leaf_bit; }
    PackedLeaf leaf() const { return PackedLeaf::from(bits_ & ~leaf_bit); }

private:
    static constexpr std::uint32_t leaf_bit = 0x80000000;
    constexpr explicit WideChild(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

/// Children on their way into a node.
struct Siblings {
    static constexpr std::size_t most = 8;

    std::array<Box, most> bounds;
    std::array<std::uint32_t, most> children;  ///< bits of a WideChild each
    std::uint32_t count = 0;

    void add(const Box& box, WideChild child) {
        bounds[count] = box;
        children[count++] = child.bits();
    }
};

/// Four cache lines: the bounds of eight children, plane by plane, and what they are.
struct alignas(64) WideNode {
    static constexpr std::size_t width = Siblings::most;

    Boxes<width> bounds;                          ///< empty where there is no child
    std::array<std::uint32_t, width> children{};  ///< bits of a WideChild each
    std::uint32_t live = 0;                       ///< children that exist, the first ones

    WideNode() = default;
    explicit WideNode(const Siblings& siblings) : live(siblings.count) {
        for (std::uint32_t i = 0; i < live; ++i) {
            bounds.set(i, siblings.bounds[i]);
            children[i] = siblings.children[i];
        }
    }
    WideChild child(std::size_t i) const { return WideChild::from(children[i]); }
};
static_assert(sizeof(WideNode) == 256);

}  // namespace rayshoot::inline RAYSHOOT_ISA
