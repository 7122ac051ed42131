#include "accel/bvh/binned_sah.h"

#include "accel/bvh/binning.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>

#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Sizes from which work is divided among threads. Where it is divided depends on nothing else, so
/// that the tree is the same for any number of them.
constexpr std::uint32_t references_per_task = 1024;
constexpr std::uint32_t references_per_chunk = 8192;

std::size_t chunks_of(std::size_t references) {
    return (references + references_per_chunk - 1) / references_per_chunk;
}
std::span<const Reference> chunk(std::span<const Reference> references, std::size_t i) {
    const std::size_t first = i * references_per_chunk;
    return references.subspan(
        first, std::min<std::size_t>(references_per_chunk, references.size() - first));
}

class Builder {
public:
    Builder(std::span<const Box> boxes, const BinnedSah& settings)
        : settings_(settings),
          tree_(boxes.size()),
          here_(boxes.size(), PageUse::passing),
          there_(boxes.size(), PageUse::passing) {
        // Boxes that no leaf may hold together are not tested at once either.
        settings_.test_width =
            std::min(settings_.test_width, std::bit_floor(settings_.largest_leaf));
    }

    BinaryTree build(std::span<const Box> boxes) && {
        Range all;
        all.count = static_cast<std::uint32_t>(boxes.size());
        all.enclosure = refer_to(boxes);
        const Extent extent = subdivide(all);
        tree_.leaves = extent.leaves;
        tree_.depth = extent.depth;
        return std::move(tree_);
    }

private:
    /// Some references, and the place of the node that is to hold them.
    struct Range {
        std::uint32_t first = 0, count = 0, node = BinaryTree::root;
        std::uint32_t pairs = BinaryTree::pairs_from(0);  ///< of its descendants, if they are few
        int depth = 0;
        bool moved = false;  ///< they are in `there_`
        Enclosure enclosure;
    };

    std::span<Reference> members(const Range& range) {
        return std::span(range.moved ? there_ : here_).subspan(range.first, range.count);
    }

    Enclosure refer_to(std::span<const Box> boxes) {
        return reduce_chunks(boxes.size(), Enclosure(), [&](const auto& part, Enclosure sum) {
            for (std::size_t i = part.begin(); i < part.end(); ++i) {
                const Reference* reference =
                    new (&here_[i]) Reference(boxes[i], static_cast<std::uint32_t>(i));
                sum.include(reference->bounds());
            }
            return sum;
        });
    }

    template <class Value, class Add>
    static Value reduce_chunks(std::size_t size, const Value& none, const Add& add) {
        return tbb::parallel_deterministic_reduce(
            tbb::blocked_range<std::size_t>(0, size, references_per_chunk), none, add,
            [](Value a, const Value& b) {
                a.include(b);
                return a;
            });
    }

    Extent subdivide(const Range& range) {
        tree_.nodes[range.node].bounds = range.enclosure.boxes.box();
        const float leaf_cost = settings_.test_cost * tests(range.count);
        const bool may_be_leaf = range.count <= settings_.largest_leaf;
        if (range.count == 1 || (may_be_leaf && leaf_cost <= settings_.step_cost))
            return make_leaf(range);
        if (out_of_depth(range)) return may_be_leaf ? make_leaf(range) : halve(range);

        const BinPlaces places(range.enclosure.centres, bins(range));
        const Split split = best_split(range, places);
        if (may_be_leaf && !(split.cost < leaf_cost)) return make_leaf(range);
        return split.axis < 0 ? halve(range) : part(range, places, split);
    }

    /// From here on only halving keeps within the deepest level.
    bool out_of_depth(const Range& range) const {
        return range.depth + 1 + static_cast<int>(std::bit_width(range.count)) >= settings_.deepest;
    }
    float tests(std::uint32_t boxes) const {
        return static_cast<float>((boxes + settings_.test_width - 1) / settings_.test_width);
    }
    /// For few boxes many bins cost more than they gain.
    int bins(const Range& range) const {
        const bool few = range.count <= 16 && settings_.save_bins;
        return few ? std::min(settings_.bins, 9) : settings_.bins;
    }

    Extent make_leaf(const Range& range) {
        tree_.nodes[range.node].first = range.first;
        tree_.nodes[range.node].count = range.count;
        const auto order = std::span(tree_.order).subspan(range.first, range.count);
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = members(range)[i].number;
        std::sort(order.begin(), order.end());
        return Extent::of_leaf(range.depth);
    }

    Split best_split(const Range& range, const BinPlaces& places) {
        const std::span<const Reference> all = members(range);
        const float area = range.enclosure.boxes.half_area();
        if (all.size() <= references_per_chunk) {
            Bins bins(this->bins(range));
            bins.add(all, places);
            return bins.best_split(area, settings_);
        }
        return reduce_chunks(all.size(), Bins(bins(range)),
                             [&](const auto& part, Bins sum) {
                                 sum.add(all.subspan(part.begin(), part.size()), places);
                                 return sum;
                             })
            .best_split(area, settings_);
    }

    /// Moves the references to the other array, the left side's first, both in their order.
    Extent part(const Range& range, const BinPlaces& places, const Split& split) {
        auto [left, right] = sides(range, split.left_count);
        left.moved = right.moved = !range.moved;
        const Side side(places, split.axis, split.bin);
        if (range.count <= references_per_chunk) {
            move(members(range), side, members(left).data(), members(right).data(),
                 left.enclosure.centres, right.enclosure.centres);
        } else {
            move_chunks(range, side, left, right);
        }
        left.enclosure.boxes = split.left;
        right.enclosure.boxes = split.right;
        return descend(range, left, right);
    }

    static void move(std::span<const Reference> from, const Side& side, Reference* left,
                     Reference* right, simd::Bounds& left_centres, simd::Bounds& right_centres) {
        std::array<Reference*, 2> to{right, left};
        simd::Bounds centres_left = left_centres, centres_right = right_centres;  // in registers
        for (const Reference& reference : from) {
            const simd::Bounds box = reference.bounds(), centre = box.centre();
            const bool is_left = side.is_left(centre);
            new (to[is_left]++)
                Reference(box);  // by a table: a branch would go wrong half the time
            centres_left.include(centre.or_nothing_unless(is_left));
            centres_right.include(centre.or_nothing_if(is_left));
        }
        left_centres = centres_left;
        right_centres = centres_right;
    }

    void move_chunks(const Range& range, const Side& side, Range& left, Range& right) {
        const std::span<const Reference> all = members(range);
        struct Chunk {
            std::size_t left = 0;
            simd::Bounds left_centres, right_centres;
        };
        std::vector<Chunk> chunks(chunks_of(all.size()));
        tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
            for (const Reference& reference : chunk(all, i))
                chunks[i].left += side.is_left(reference.bounds().centre());
        });
        std::size_t before = 0;
        for (Chunk& c : chunks) before += std::exchange(c.left, before);
        tbb::parallel_for(std::size_t{0}, chunks.size(), [&](std::size_t i) {
            Chunk& c = chunks[i];
            move(chunk(all, i), side, members(left).data() + c.left,
                 members(right).data() + (i * references_per_chunk - c.left), c.left_centres,
                 c.right_centres);
        });
        for (const Chunk& c : chunks) {
            left.enclosure.centres.include(c.left_centres);
            right.enclosure.centres.include(c.right_centres);
        }
    }

    Extent halve(const Range& range) {
        auto [left, right] = sides(range, range.count / 2);
        for (Range* side : {&left, &right})
            for (const Reference& reference : members(*side))
                side->enclosure.include(reference.bounds());
        return descend(range, left, right);
    }

    std::pair<Range, Range> sides(const Range& range, std::uint32_t left_count) const {
        const std::uint32_t middle = range.first + left_count;
        const std::uint32_t pair = is_task(range) ? BinaryTree::pair_at(middle) : range.pairs;
        const int depth = range.depth + 1;
        return {{range.first, left_count, pair, 0, depth, range.moved, {}},
                {middle, range.count - left_count, pair + 1, 0, depth, range.moved, {}}};
    }

    static bool is_task(const Range& range) { return range.count > references_per_task; }

    Extent descend(const Range& range, Range left, Range right) {
        tree_.nodes[range.node].first = left.node;
        tree_.nodes[range.node].count = 0;
        if (!is_task(range)) {
            left.pairs = range.pairs + 2;
            const Extent first = subdivide(left);
            right.pairs = left.pairs + 2 * (first.leaves - 1);
            return first + subdivide(right);
        }
        left.pairs = BinaryTree::pairs_from(left.first);
        right.pairs = BinaryTree::pairs_from(right.first);
        Extent first, second;
        tbb::parallel_invoke([&] { first = subdivide(left); }, [&] { second = subdivide(right); });
        return first + second;
    }

    BinnedSah settings_;
    BinaryTree tree_;
    RawArray<Reference> here_, there_;
};

}  // namespace

BinaryTree build_binned_sah(std::span<const Box> boxes, const BinnedSah& settings) {
    if (boxes.empty()) return {};
    return Builder(boxes, settings).build(boxes);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
