#include "accel/bvh/bvh.h"

#include "accel/bvh/builders.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Pairs of children in depth-first order, so that a node and its left child are neighbours.
class Layout {
public:
    explicit Layout(const BinaryTree& tree) : tree_(tree) {}

    PagedVector<Bvh::Node> nodes() && {
        nodes_.reserve(tree_.leaves + 1);
        nodes_.emplace_back();
        if (tree_.nodes.empty()) return std::move(nodes_);
        if (tree_.nodes.front().count > 0) fill(0, 0, 0);
        else descend();
        return std::move(nodes_);
    }

private:
    struct Pending {
        std::uint32_t source, parent;
        std::size_t side;
    };

    void descend() {
        split(0, 0);
        while (!pending_.empty()) {
            const Pending next = pending_.back();
            pending_.pop_back();
            const auto node = static_cast<std::uint32_t>(nodes_.size());
            nodes_.emplace_back();
            nodes_[next.parent].child[next.side] = {node, 0};
            split(next.source, node);
        }
    }

    void split(std::uint32_t source, std::uint32_t node) {
        const std::uint32_t left = tree_.nodes[source].first;
        for (const std::size_t side : {1u, 0u}) {
            const std::uint32_t child = left + static_cast<std::uint32_t>(side);
            if (tree_.nodes[child].count > 0) {
                fill(child, node, side);
            } else {
                nodes_[node].bounds.set(side, tree_.nodes[child].bounds);
                pending_.push_back({child, node, side});
            }
        }
    }

    void fill(std::uint32_t leaf, std::uint32_t node, std::size_t side) {
        nodes_[node].bounds.set(side, tree_.nodes[leaf].bounds);
        nodes_[node].child[side] = {tree_.nodes[leaf].first, tree_.nodes[leaf].count};
    }

    const BinaryTree& tree_;
    PagedVector<Bvh::Node> nodes_;
    std::vector<Pending> pending_;
};

/// In the order of `order`.
std::vector<LeafRange> leaf_ranges(const BinaryTree& tree) {
    std::vector<LeafRange> ranges;
    ranges.reserve(tree.leaves);
    std::vector<std::uint32_t> pending;
    if (!tree.nodes.empty()) pending.push_back(BinaryTree::root);
    while (!pending.empty()) {
        const BinaryTree::Node& node = tree.nodes[pending.back()];
        pending.pop_back();
        if (node.count > 0) ranges.push_back({node.first, node.count});
        else pending.insert(pending.end(), {node.first + 1, node.first});
    }
    return ranges;
}

}  // namespace

Bvh::Bvh(const BuildInput& input, const Options& chosen) {
    const BinaryTree tree = build_tree(
        input.geometry.all_bounds(),
        {.build = chosen_build(chosen),
         .sah = {.bins = chosen.integer("bins", 2, BinnedSah::most_bins),
                 .largest_leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 64)),
                 .deepest = deepest}});
    const std::vector<LeafRange> ranges = leaf_ranges(tree);
    nodes_ = Layout(tree).nodes();
    leaves_ = Leaves(input.geometry, tree.order, ranges);
    footprint_ = {.interior = tree.leaves == 0 ? 0 : tree.leaves - 1,
                  .leaves = ranges.size(),
                  .empty_leaves = 0,
                  .references = tree.order.size(),
                  .depth = static_cast<std::uint64_t>(tree.depth),
                  .bytes = nodes_.size() * sizeof(Node) + leaves_.bytes()};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
