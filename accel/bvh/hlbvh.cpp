#include "accel/bvh/hlbvh.h"

#include "accel/bvh/clusters.h"
#include "accel/simd/bounds.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Boxes of a sub-tree that is built by Morton codes. Fewer make a better tree, more a faster
/// build.
constexpr std::uint32_t most_in_cluster = 32;
/// Levels of such a sub-tree: halving from any of its nodes on must not exceed them.
constexpr int levels_of_cluster = 2 * static_cast<int>(std::bit_width(most_in_cluster));

class Builder {
public:
    Builder(std::span<const Box> boxes, const BinnedSah& settings)
        : boxes_(boxes),
          settings_(settings),
          tree_(boxes.size()),
          clusters_(boxes, most_in_cluster),
          roots_(clusters_.size()),
          extents_(clusters_.size()) {}

    BinaryTree build() && {
        std::vector<Box> bounds(clusters_.size());
        tbb::parallel_for(std::size_t{0}, clusters_.size(), [&](std::size_t i) {
            extents_[i] = emit(clusters_[i], clusters_.first(i), roots_[i], 0);
            bounds[i] = roots_[i].bounds;
        });
        BinnedSah above = settings_;
        above.largest_leaf = above.test_width = 1;
        above.deepest = settings_.deepest - levels_of_cluster;
        const BinaryTree upper = build_binned_sah(bounds, above);
        const Extent all = graft(upper, BinaryTree::root, BinaryTree::root, 0);
        tree_.leaves = all.leaves;
        tree_.depth = all.depth;
        return std::move(tree_);
    }

private:
    using Keys = std::span<const MortonKey>;

    /// `first`: the place of the first key.
    Extent emit(Keys keys, std::uint32_t first, BinaryTree::Node& node, int depth) {
        if (keys.size() <= settings_.largest_leaf) return make_leaf(keys, first, node, depth);
        const std::uint32_t left = split(keys, depth);
        node.first = BinaryTree::pair_at(first + left);
        node.count = 0;
        BinaryTree::Node* pair = &tree_.nodes[node.first];
        const Extent extent = emit(keys.first(left), first, pair[0], depth + 1) +
                              emit(keys.subspan(left), first + left, pair[1], depth + 1);
        node.bounds = pair[0].bounds;
        node.bounds.include(pair[1].bounds);
        return extent;
    }

    std::uint32_t split(Keys keys, int depth) const {
        const bool few_leaves = keys.size() <= 4 * settings_.largest_leaf;
        if (few_leaves) return split_into_full_leaves(keys, settings_.largest_leaf);
        const bool out_of_depth =
            depth + 1 + static_cast<int>(std::bit_width(keys.size())) >= levels_of_cluster;
        return out_of_depth ? static_cast<std::uint32_t>(keys.size() / 2) : radix_split(keys);
    }

    Extent make_leaf(Keys keys, std::uint32_t first, BinaryTree::Node& node, int depth) {
        simd::Bounds bounds;
        const auto order = std::span(tree_.order).subspan(first, keys.size());
        for (std::size_t i = 0; i < keys.size(); ++i) {
            order[i] = keys[i].number();
            bounds.include(simd::Bounds(boxes_[order[i]]));
        }
        std::sort(order.begin(), order.end());
        node = {bounds.box(), first, static_cast<std::uint32_t>(keys.size())};
        return Extent::of_leaf(depth);
    }

    /// Copies the upper tree, whose pairs part clusters where ours part boxes.
    Extent graft(const BinaryTree& upper, std::uint32_t from, std::uint32_t to, int depth) {
        const BinaryTree::Node& node = upper.nodes[from];
        if (node.count > 0) {
            const std::uint32_t cluster = upper.order[node.first];
            tree_.nodes[to] = roots_[cluster];
            return {extents_[cluster].leaves, depth + extents_[cluster].depth};
        }
        const std::uint32_t pair = BinaryTree::pair_at(clusters_.first(node.first / 2));
        tree_.nodes[to] = {node.bounds, pair, 0};
        return graft(upper, node.first, pair, depth + 1) +
               graft(upper, node.first + 1, pair + 1, depth + 1);
    }

    std::span<const Box> boxes_;
    BinnedSah settings_;
    BinaryTree tree_;
    MortonClusters clusters_;
    RawArray<BinaryTree::Node> roots_;  ///< of the clusters
    RawArray<Extent> extents_;
};

}  // namespace

BinaryTree build_hlbvh(std::span<const Box> boxes, const BinnedSah& settings) {
    if (boxes.empty()) return {};
    return Builder(boxes, settings).build();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
