#pragma once

#include "accel/core/box.h"
#include "accel/simd/packed_leaves.h"
#include "accel/simd/quantised_boxes.h"

/// Nodes of a wide tree, and what their children are.
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

inline constexpr std::size_t most_children = 8;  ///< of any node

/// Children on their way into a node.
struct Siblings {
    std::array<Box, most_children> bounds;
    std::array<std::uint32_t, most_children> children;  ///< bits of a WideChild each
    std::uint32_t count = 0;

    void add(const Box& box, WideChild child) {
        bounds[count] = box;
        children[count++] = child.bits();
    }
};

/// The bounds of some children side by side, and what they are; never on more cache lines than its
/// size asks for.
template <class Bounds>
struct alignas(sizeof(Bounds) > 64 ? 64 : 32) WideNode {
    static constexpr std::size_t width = Bounds::width;
    static_assert(width <= most_children);

    Bounds bounds;                              ///< met by no ray where there is no child
    std::array<std::uint32_t, width> children;  ///< bits of a WideChild each

    WideNode() { children.fill(WideChild::none().bits()); }
    explicit WideNode(const Siblings& siblings) : WideNode() {
        Boxes<width> exact;
        for (std::uint32_t i = 0; i < siblings.count; ++i) {
            exact.set(i, siblings.bounds[i]);
            children[i] = siblings.children[i];
        }
        bounds = Bounds(exact);
    }

    WideChild child(std::size_t i) const { return WideChild::from(children[i]); }
    /// Children that exist, the first ones.
    std::size_t live() const {
        std::size_t count = 0;
        while (count < width && !child(count).is_none()) ++count;
        return count;
    }
};
/// Four cache lines.
using WideNode8 = WideNode<Boxes<8>>;
static_assert(sizeof(WideNode8) == 256);
/// Two.
using WideNode4 = WideNode<Boxes<4>>;
static_assert(sizeof(WideNode4) == 128);
/// One and a half: always on two.
using WideNode8q = WideNode<QuantisedBoxes>;
static_assert(sizeof(WideNode8q) == 96);

}  // namespace rayshoot::inline RAYSHOOT_ISA
