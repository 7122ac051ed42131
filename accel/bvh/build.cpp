#include "accel/bvh/build.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

struct Split {
    int axis = -1;  ///< -1: none
    int bin = 0;    ///< first bin of the right side
    float cost = infinity;
};

struct Bin {
    Box bounds;
    std::uint32_t count = 0;
};

/// Where a box's centre falls among the bins of an axis; the same expression bins and partitions.
struct Binning {
    float lo, scale;
    int bins;

    Binning(float from, float to, int n)
        : lo(from), scale(static_cast<float>(n) / (to - from)), bins(n) {}
    bool usable() const { return scale > 0 && std::isfinite(scale); }
    int operator()(float centre) const {
        const int bin = static_cast<int>((centre - lo) * scale);
        return std::clamp(bin, 0, bins - 1);
    }
};

class Builder {
public:
    Builder(std::span<const Box> boxes, const BinnedSah& settings)
        : boxes_(boxes),
          settings_(settings),
          bins_(static_cast<std::size_t>(settings.bins)),
          right_cost_(bins_.size()) {
        tree_.order.resize(boxes.size());
        std::iota(tree_.order.begin(), tree_.order.end(), 0u);
        centres_.reserve(boxes.size());
        for (const Box& box : boxes) centres_.push_back(box.centre());
    }

    BinaryTree build() && {
        if (boxes_.empty()) return {};
        tree_.nodes.reserve(2 * boxes_.size());
        tree_.nodes.emplace_back();
        pending_.push_back({0, 0, static_cast<std::uint32_t>(boxes_.size()), 0});
        while (!pending_.empty()) {
            const Range range = pending_.back();
            pending_.pop_back();
            subdivide(range);
        }
        return std::move(tree_);
    }

private:
    struct Range {
        std::uint32_t node, first, count;
        int depth;
    };

    std::span<std::uint32_t> members(const Range& range) {
        return std::span(tree_.order).subspan(range.first, range.count);
    }

    void subdivide(const Range& range) {
        Box bounds, centres;
        for (const std::uint32_t box : members(range)) {
            bounds.include(boxes_[box]);
            centres.include(centres_[box]);
        }
        tree_.nodes[range.node].bounds = bounds;
        tree_.depth = std::max(tree_.depth, range.depth);
        if (range.count == 1) return make_leaf(range);

        const Split split = out_of_depth(range) ? Split{} : best_split(range, bounds, centres);
        const float leaf_cost = settings_.test_cost * tests(range.count);
        if (range.count <= settings_.largest_leaf && !(split.cost < leaf_cost))
            return make_leaf(range);
        divide(range, split.axis < 0 ? range.count / 2 : partition(range, centres, split));
    }

    /// From here on only halving keeps within the deepest level.
    bool out_of_depth(const Range& range) const {
        return range.depth + 1 + static_cast<int>(std::bit_width(range.count)) >= settings_.deepest;
    }

    void make_leaf(const Range& range) {
        tree_.nodes[range.node].first = range.first;
        tree_.nodes[range.node].count = range.count;
        std::sort(members(range).begin(), members(range).end());
    }

    void divide(const Range& range, std::uint32_t left) {
        const auto child = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes[range.node].first = child;
        tree_.nodes.resize(tree_.nodes.size() + 2);
        pending_.push_back({child + 1, range.first + left, range.count - left, range.depth + 1});
        pending_.push_back({child, range.first, left, range.depth + 1});
    }

    Split best_split(const Range& range, const Box& bounds, const Box& centres) {
        Split best;
        const float area = bounds.half_area();
        for (int axis = 0; axis < 3; ++axis) {
            const Binning bin_of(centres.lo[axis], centres.hi[axis], settings_.bins);
            if (!bin_of.usable()) continue;
            fill_bins(range, axis, bin_of);
            sweep(axis, area, best);
        }
        return best;
    }

    void fill_bins(const Range& range, int axis, const Binning& bin_of) {
        std::fill(bins_.begin(), bins_.end(), Bin{});
        for (const std::uint32_t box : members(range)) {
            Bin& bin = bins_[static_cast<std::size_t>(bin_of(centres_[box][axis]))];
            bin.bounds.include(boxes_[box]);
            ++bin.count;
        }
    }

    /// From the right for the costs of all right sides, from the left for the sum.
    void sweep(int axis, float area, Split& best) {
        Bin side;
        for (std::size_t i = bins_.size() - 1; i > 0; --i) {
            absorb(side, bins_[i]);
            right_cost_[i] = cost(side);
        }
        side = {};
        for (std::size_t i = 1; i < bins_.size(); ++i) {
            absorb(side, bins_[i - 1]);
            const float both = cost(side) + right_cost_[i];
            const float total =
                settings_.step_cost + settings_.test_cost * (area > 0 ? both / area : both);
            if (side.count > 0 && std::isfinite(right_cost_[i]) && right_cost_[i] >= 0 &&
                total < best.cost)
                best = {axis, static_cast<int>(i), total};
        }
    }

    static void absorb(Bin& side, const Bin& bin) {
        side.bounds.include(bin.bounds);
        side.count += bin.count;
    }
    /// Infinite for an empty side, so that it is never chosen.
    float cost(const Bin& side) const {
        return side.count == 0 ? infinity : side.bounds.half_area() * tests(side.count);
    }
    float tests(std::uint32_t primitives) const {
        const std::uint32_t width = settings_.test_width;
        return static_cast<float>((primitives + width - 1) / width);
    }

    std::uint32_t partition(const Range& range, const Box& centres, const Split& split) {
        const Binning bin_of(centres.lo[split.axis], centres.hi[split.axis], settings_.bins);
        const auto all = members(range);
        const auto middle = std::stable_partition(all.begin(), all.end(), [&](std::uint32_t box) {
            return bin_of(centres_[box][split.axis]) < split.bin;
        });
        return static_cast<std::uint32_t>(middle - all.begin());
    }

    std::span<const Box> boxes_;
    BinnedSah settings_;
    BinaryTree tree_;
    std::vector<vec3> centres_;
    std::vector<Bin> bins_;
    std::vector<float> right_cost_;
    std::vector<Range> pending_;
};

}  // namespace

BinaryTree build_binned_sah(std::span<const Box> boxes, const BinnedSah& settings) {
    return Builder(boxes, settings).build();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
