#pragma once

#include "accel/bvh/binary_tree.h"
#include "accel/bvh8/node.h"

#include <bit>

/// From two children a node to several.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The binary nodes that become the children of one wide node.
struct Children {
    std::array<std::uint32_t, most_children> nodes;
    std::uint32_t count;

    const std::uint32_t* begin() const { return nodes.data(); }
    const std::uint32_t* end() const { return begin() + count; }
};

/// Of the children the one with the largest box is replaced by its own two until there are enough
/// (Wald, Benthin & Boulos 2008).
class Collapse {
public:
    Collapse(const BinaryTree& tree, std::uint32_t node, std::size_t enough) : tree_(tree) {
        areas_.fill(leaf);
        set(0, node);
        while (children_.count < enough && open_largest()) {
        }
    }
    const Children& children() const { return children_; }

private:
    void set(std::uint32_t i, std::uint32_t number) {
        const BinaryTree::Node& node = tree_.nodes[number];
        children_.nodes[i] = number;
        if (node.count == 0) __builtin_prefetch(&tree_.nodes[node.first]);
        const float area = node.bounds.half_area();
        areas_[i] = node.count > 0 ? leaf : area >= 0 ? area : 0;  // NaN: flat, and unbounded
    }
    bool open_largest() {
        using namespace simd;
        constexpr auto tag = floats<most_children>;
        const auto areas = hn::Load(tag, areas_.data());
        const auto largest_area = hn::MaxOfLanes(tag, areas);
        const auto largest =
            static_cast<std::uint32_t>(std::countr_zero(bits(tag, hn::Eq(areas, largest_area))));
        if (areas_[largest] == leaf) return false;
        const std::uint32_t left = tree_.nodes[children_.nodes[largest]].first;
        set(largest, left);
        set(children_.count++, left + 1);
        return true;
    }

    static constexpr float leaf = -1;  ///< less than any area
    const BinaryTree& tree_;
    Children children_{.nodes = {}, .count = 1};
    alignas(32) std::array<float, most_children> areas_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
