#include "accel/bvh8/bvh8.h"

#include "accel/bvh/builders.h"
#include "accel/simd/leaf_packer.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// The binary nodes that become the children of one wide node: the one with the largest box is
/// replaced by its two children until there are eight (Wald, Benthin & Boulos 2008).
class Children {
public:
    Children(const BinaryTree& tree, std::uint32_t node) : tree_(tree) {
        add(node);
        while (size_ < WideNode::width && open_largest()) {
        }
    }
    std::size_t size() const { return size_; }
    std::uint32_t operator[](std::size_t i) const { return nodes_[i]; }

private:
    void add(std::uint32_t node) { nodes_[size_++] = node; }
    bool open_largest() {
        std::size_t largest = size_;
        float area = -1;
        for (std::size_t i = 0; i < size_; ++i) {
            const BinaryTree::Node& node = tree_.nodes[nodes_[i]];
            if (node.count > 0 || !(node.bounds.half_area() > area)) continue;
            largest = i;
            area = node.bounds.half_area();
        }
        if (largest == size_) return false;
        const std::uint32_t left = tree_.nodes[nodes_[largest]].first;
        nodes_[largest] = left;
        add(left + 1);
        return true;
    }

    const BinaryTree& tree_;
    std::array<std::uint32_t, WideNode::width> nodes_;
    std::size_t size_ = 0;
};

/// Lays a binary tree out as wide nodes, depth first, and its leaves in the order of the nodes.
class Layout {
public:
    Layout(const Geometry& geometry, const BinaryTree& tree) : leaves(geometry), tree_(tree) {
        nodes.reserve(tree.nodes.size() / 6 + 1);
        nodes.emplace_back();
        if (!tree.nodes.empty()) pending_.push_back({0, 0});
        while (!pending_.empty()) {
            const Pending next = pending_.back();
            pending_.pop_back();
            fill(next);
        }
    }

    PagedVector<WideNode> nodes;
    LeafPacker leaves;

private:
    struct Pending {
        std::uint32_t source, node;
    };

    void fill(const Pending& place) {
        const Children children(tree_, place.source);
        nodes[place.node].live = static_cast<std::uint32_t>(children.size());
        for (std::size_t i = 0; i < children.size(); ++i) {
            const BinaryTree::Node& child = tree_.nodes[children[i]];
            nodes[place.node].bounds.set(i, child.bounds);
            if (child.count > 0) {
                nodes[place.node].children[i] = leaf(child).bits();
            } else {
                const auto number = static_cast<std::uint32_t>(nodes.size());
                nodes.emplace_back();
                nodes[place.node].children[i] = WideChild::node(number).bits();
                pending_.push_back({children[i], number});
            }
        }
    }

    WideChild leaf(const BinaryTree::Node& leaf) {
        return WideChild::leaf(leaves.add(std::span(tree_.order).subspan(leaf.first, leaf.count)));
    }

    const BinaryTree& tree_;
    std::vector<Pending> pending_;
};

}  // namespace

Bvh8::Bvh8(const BuildInput& input, const Options& chosen) {
    const BinaryTree tree = build_tree(
        input.geometry.all_bounds(),
        {.build = chosen_build(chosen),
         .sah = {.bins = chosen.integer("bins", 2, BinnedSah::most_bins),
                 .largest_leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 32)),
                 .deepest = Stack::deepest,
                 .test_width = TriangleBlock::width}});
    Layout layout(input.geometry, tree);
    nodes_ = std::move(layout.nodes);
    leaves_ = std::move(layout.leaves).build();
    firsts_ = {reinterpret_cast<const std::byte*>(nodes_.data()), leaves_.first()};
    footprint_ = {.interior = nodes_.size(),
                  .leaves = tree.leaves,
                  .empty_leaves = 0,
                  .references = tree.order.size(),
                  .depth = static_cast<std::uint64_t>(tree.depth),
                  .bytes = nodes_.size() * sizeof(WideNode) + leaves_.bytes()};
    packets_ = chosen.flag("packets") && leaves_.only_triangles() &&
               input.geometry.precision() == Precision::standard;
    in_flight_ = static_cast<std::size_t>(chosen.integer("flight", 1, most_flights));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
