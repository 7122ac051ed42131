#include "accel/bvh/hlbvh.h"

#include "accel/bvh/morton.h"
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
          keys_(sorted_morton_keys(boxes)) {
        find_clusters();
    }

    BinaryTree build() && {
        const std::size_t clusters = first_of_.size() - 1;
        roots_ = RawArray<BinaryTree::Node>(clusters);
        extents_ = RawArray<Extent>(clusters);
        std::vector<Box> bounds(clusters);
        for_clusters([&](std::size_t i) {
            extents_[i] = emit({first_of_[i], first_of_[i + 1]}, roots_[i], 0);
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
    struct Range {
        std::uint32_t first, last;
        std::uint32_t count() const { return last - first; }
    };

    template <class Work>
    void for_clusters(const Work& work) {
        tbb::parallel_for(std::size_t{0}, first_of_.size() - 1, work);
    }

    /// The largest nodes of the tree over all Morton keys that are small enough.
    void find_clusters() {
        std::vector<Range> pending{{0, static_cast<std::uint32_t>(boxes_.size())}};
        while (!pending.empty()) {
            const Range range = pending.back();
            pending.pop_back();
            if (range.count() <= most_in_cluster) {
                first_of_.push_back(range.first);
                continue;
            }
            const std::uint32_t middle = split(range);
            pending.push_back({middle, range.last});
            pending.push_back({range.first, middle});
        }
        first_of_.push_back(static_cast<std::uint32_t>(boxes_.size()));
    }

    /// Where the highest bit that differs becomes 1 (Lauterbach et al. 2009).
    std::uint32_t split(const Range& range) const {
        const std::uint64_t low = keys_[range.first].bits(), high = keys_[range.last - 1].bits();
        const std::uint64_t from = high >> (std::bit_width(low ^ high) - 1)
                                               << (std::bit_width(low ^ high) - 1);
        const auto middle =
            std::partition_point(keys_.begin() + range.first, keys_.begin() + range.last,
                                 [from](const MortonKey& key) { return key.bits() < from; });
        return static_cast<std::uint32_t>(middle - keys_.begin());
    }

    /// The same among the places that cost no more leaves than need be.
    std::uint32_t split_into_full_leaves(const Range& range) const {
        std::uint32_t best = range.first + settings_.largest_leaf;
        std::uint64_t difference = 0;
        for (std::uint32_t i = range.first + 1; i < range.last; ++i) {
            const std::uint64_t here = keys_[i - 1].bits() ^ keys_[i].bits();
            const std::uint32_t needed = leaves_for(i - range.first) + leaves_for(range.last - i);
            if (here <= difference || needed > leaves_for(range.count())) continue;
            best = i;
            difference = here;
        }
        return best;
    }
    std::uint32_t leaves_for(std::uint32_t boxes) const {
        return (boxes + settings_.largest_leaf - 1) / settings_.largest_leaf;
    }

    Extent emit(const Range& range, BinaryTree::Node& node, int depth) {
        if (range.count() <= settings_.largest_leaf) return make_leaf(range, node, depth);
        const bool out_of_depth =
            depth + 1 + static_cast<int>(std::bit_width(range.count())) >= levels_of_cluster;
        const bool few_leaves = range.count() <= 4 * settings_.largest_leaf;
        const std::uint32_t middle = few_leaves     ? split_into_full_leaves(range)
                                     : out_of_depth ? range.first + range.count() / 2
                                                    : split(range);
        node.first = BinaryTree::pair_at(middle);
        node.count = 0;
        BinaryTree::Node* pair = &tree_.nodes[node.first];
        const Extent extent = emit({range.first, middle}, pair[0], depth + 1) +
                              emit({middle, range.last}, pair[1], depth + 1);
        node.bounds = pair[0].bounds;
        node.bounds.include(pair[1].bounds);
        return extent;
    }

    Extent make_leaf(const Range& range, BinaryTree::Node& node, int depth) {
        simd::Bounds bounds;
        for (std::uint32_t i = range.first; i < range.last; ++i) {
            tree_.order[i] = keys_[i].number();
            bounds.include(simd::Bounds(boxes_[tree_.order[i]]));
        }
        std::sort(tree_.order.begin() + range.first, tree_.order.begin() + range.last);
        node = {bounds.box(), range.first, range.count()};
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
        const std::uint32_t pair = BinaryTree::pair_at(first_of_[node.first / 2]);
        tree_.nodes[to] = {node.bounds, pair, 0};
        return graft(upper, node.first, pair, depth + 1) +
               graft(upper, node.first + 1, pair + 1, depth + 1);
    }

    std::span<const Box> boxes_;
    BinnedSah settings_;
    BinaryTree tree_;
    RawArray<MortonKey> keys_;
    std::vector<std::uint32_t> first_of_;  ///< of each cluster its first key, and the end
    RawArray<BinaryTree::Node> roots_;     ///< of the clusters
    RawArray<Extent> extents_;
};

}  // namespace

BinaryTree build_hlbvh(std::span<const Box> boxes, const BinnedSah& settings) {
    if (boxes.empty()) return {};
    return Builder(boxes, settings).build();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
