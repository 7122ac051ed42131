#include "accel/bvh8/wide_hlbvh.h"

#include "accel/bvh/clusters.h"
#include "accel/bvh8/collapse.h"
#include "accel/simd/bounds.h"
#include "accel/simd/leaf_packer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Most nodes above so many clusters: where a node has less than `width` children these are all
/// clusters, at least two of them.
std::size_t most_nodes_above(std::size_t clusters, std::size_t width) {
    const std::size_t lowest = clusters / 2;
    return clusters < 2 ? 0 : lowest + lowest / (width - 1) + 1;
}

template <class Node>
class Builder {
public:
    /// At least one primitive.
    Builder(const Geometry& geometry, const BinnedSah& settings)
        : boxes_(geometry.all_bounds()),
          settings_(settings),
          largest_leaf_(std::min<std::uint32_t>(settings.largest_leaf, TriangleBlock::width)),
          clusters_(boxes_, Node::width * largest_leaf_),
          first_leaf_(clusters_.size() + 1),
          nodes_(clusters_.size() + most_nodes_above(clusters_.size(), Node::width)),
          packer_(geometry) {
        for (std::size_t i = 0; i < clusters_.size(); ++i)
            first_leaf_[i + 1] = first_leaf_[i] + leaves_for(clusters_[i].size());
        parallel_ = packer_.make_room_for_triangles(first_leaf_.back());
    }

    WideTree<Node> build() && {
        std::vector<Box> bounds(clusters_.size());
        if (parallel_) {
            tbb::parallel_for(std::size_t{0}, bounds.size(),
                              [&](std::size_t i) { bounds[i] = make_cluster(i); });
        } else {
            for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i] = make_cluster(i);
        }
        const int depth = bounds.size() == 1 ? 0 : build_above(bounds);
        nodes_.shrink(used_);
        return {std::move(nodes_), std::move(packer_).build(), first_leaf_.back(), depth + 1};
    }

private:
    using Keys = std::span<const MortonKey>;

    std::uint32_t leaves_for(std::size_t boxes) const {
        return (static_cast<std::uint32_t>(boxes) + largest_leaf_ - 1) / largest_leaf_;
    }
    /// The root comes first, then the clusters, then all other nodes.
    std::uint32_t place_of(std::size_t cluster) const {
        return static_cast<std::uint32_t>(cluster) + (clusters_.size() > 1 ? 1 : 0);
    }

    /// Returns its bounds.
    Box make_cluster(std::size_t i) {
        Siblings leaves;
        add_leaves(clusters_[i], first_leaf_[i], leaves);
        new (&nodes_[place_of(i)]) Node(leaves);
        Box bounds;
        for (std::uint32_t leaf = 0; leaf < leaves.count; ++leaf)
            bounds.include(leaves.bounds[leaf]);
        return bounds;
    }

    void add_leaves(Keys keys, std::uint32_t first_leaf, Siblings& leaves) {
        if (keys.size() <= largest_leaf_) return add_leaf(keys, first_leaf, leaves);
        const std::uint32_t left = split_into_full_leaves(keys, largest_leaf_);
        add_leaves(keys.first(left), first_leaf, leaves);
        add_leaves(keys.subspan(left), first_leaf + leaves_for(left), leaves);
    }

    void add_leaf(Keys keys, std::uint32_t number, Siblings& leaves) {
        std::array<std::uint32_t, TriangleBlock::width> order;
        const auto members = std::span(order).first(keys.size());
        simd::Bounds bounds;
        for (std::size_t i = 0; i < keys.size(); ++i) {
            members[i] = keys[i].number();
            bounds.include(simd::Bounds(boxes_[members[i]]));
        }
        leaves.add(bounds.box(), WideChild::leaf(parallel_ ? packer_.set_triangles(number, members)
                                                           : packer_.add(members)));
    }

    /// Binned SAH over the clusters. Returns the depth of the deepest one.
    int build_above(std::span<const Box> bounds) {
        BinnedSah above = settings_;
        above.largest_leaf = above.test_width = 1;
        above.deepest = settings_.deepest - 1;
        const BinaryTree tree = build_binned_sah(bounds, above);
        used_ = place_of(bounds.size());
        make_node(tree, BinaryTree::root, 0);
        return tree.depth;
    }

    void make_node(const BinaryTree& tree, std::uint32_t from, std::uint32_t to) {
        const Children children = Collapse(tree, from, Node::width).children();
        Siblings siblings;
        for (const std::uint32_t i : children) {
            const BinaryTree::Node& child = tree.nodes[i];
            const bool is_cluster = child.count > 0;
            const std::uint32_t place = is_cluster ? place_of(tree.order[child.first]) : used_++;
            if (!is_cluster) make_node(tree, i, place);
            siblings.add(child.bounds, WideChild::node(place));
        }
        new (&nodes_[to]) Node(siblings);
    }

    std::span<const Box> boxes_;
    BinnedSah settings_;
    std::uint32_t largest_leaf_;  ///< a block, so that their number is known beforehand
    MortonClusters clusters_;
    std::vector<std::uint32_t> first_leaf_;  ///< of each cluster, and the end
    RawArray<Node> nodes_;
    std::uint32_t used_ = 1;  ///< nodes that have a place
    LeafPacker packer_;
    bool parallel_ = false;
};

}  // namespace

template <class Node>
WideTree<Node> build_wide_hlbvh(const Geometry& geometry, const BinnedSah& settings) {
    if (geometry.size() == 0) return laid_out<Node>(geometry, {});
    return Builder<Node>(geometry, settings).build();
}

template WideTree<WideNode8> build_wide_hlbvh(const Geometry&, const BinnedSah&);
template WideTree<WideNode4> build_wide_hlbvh(const Geometry&, const BinnedSah&);
template WideTree<WideNode8q> build_wide_hlbvh(const Geometry&, const BinnedSah&);

}  // namespace rayshoot::inline RAYSHOOT_ISA
