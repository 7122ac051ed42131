#include "accel/bsp/sah.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <array>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr std::size_t most_bins = 64, references_per_chunk = 8192;

/// Where faces fall into bins: lanes as in a Reference.
class BinPlaces {
public:
    using V = simd::Floats<8>;

    BinPlaces(const Box& box, int bins) : last_(static_cast<float>(bins - 1)) {
        alignas(32) std::array<float, 8> origin{}, scale{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int a = static_cast<int>(axis);
            const float size = box.hi[a] - box.lo[a];
            const float per_length = size > 0 ? static_cast<float>(bins) / size : 0;
            origin[axis] = box.lo[a];
            origin[axis + 4] = -box.lo[a];
            scale[axis] = std::isfinite(per_length) ? per_length : 0;
            scale[axis + 4] = -scale[axis];
        }
        origin_ = simd::hn::Load(tag, origin.data());
        scale_ = simd::hn::Load(tag, scale.data());
    }
    /// The bins of lo.x, lo.y, lo.z, any, hi.x, hi.y, hi.z, any.
    std::array<std::int32_t, 8> of(const Reference& reference) const {
        using namespace simd;
        const auto place = hn::Mul(hn::Sub(reference.bounds().planes(), origin_), scale_);
        const auto within = smaller(larger(place, hn::Zero(tag)), hn::Set(tag, last_));
        alignas(32) std::array<std::int32_t, 8> bins;
        hn::Store(hn::ConvertTo(hn::RebindToSigned<decltype(tag)>(), within),
                  hn::RebindToSigned<decltype(tag)>(), bins.data());
        return bins;
    }

private:
    static constexpr simd::hn::FixedTag<float, 8> tag{};
    V origin_, scale_;
    float last_;
};

/// How many boxes begin and end in each bin of each axis.
struct Bins {
    using Row = std::array<std::uint32_t, most_bins>;
    std::array<Row, 3> starts{}, ends{};

    void add(std::span<const Reference> references, const BinPlaces& places) {
        for (const Reference& reference : references) {
            const auto bins = places.of(reference);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                ++starts[axis][static_cast<std::size_t>(bins[axis])];
                ++ends[axis][static_cast<std::size_t>(bins[axis + 4])];
            }
        }
    }
    void add(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t bin = 0; bin < most_bins; ++bin) {
                starts[axis][bin] += other.starts[axis][bin];
                ends[axis][bin] += other.ends[axis][bin];
            }
    }
};

Bins binned(std::span<const Reference> references, const BinPlaces& places) {
    if (references.size() <= 2 * references_per_chunk) {
        Bins bins;
        bins.add(references, places);
        return bins;
    }
    return tbb::parallel_reduce(
        tbb::blocked_range<std::size_t>(0, references.size(), references_per_chunk), Bins(),
        [&](const auto& part, Bins sum) {
            sum.add(references.subspan(part.begin(), part.size()), places);
            return sum;
        },
        [](Bins a, const Bins& b) {
            a.add(b);
            return a;
        });
}

Box enclosing(std::span<const Reference> references) {
    if (references.size() <= 2 * references_per_chunk) {
        simd::Bounds all;
        for (const Reference& reference : references) all.include(reference.bounds());
        return all.box();
    }
    return tbb::parallel_reduce(
               tbb::blocked_range<std::size_t>(0, references.size(), references_per_chunk),
               simd::Bounds(),
               [&](const auto& part, simd::Bounds all) {
                   for (std::size_t i = part.begin(); i < part.end(); ++i)
                       all.include(references[i].bounds());
                   return all;
               },
               [](simd::Bounds a, const simd::Bounds& b) {
                   a.include(b);
                   return a;
               })
        .box();
}

/// The planes of one axis.
class Planes {
public:
    Planes(const Sah& sah, const Box& cell, int axis)
        : sah_(sah), chances_(cell, axis), lo_(cell.lo[axis]), hi_(cell.hi[axis]), axis_(axis) {}

    void improve(KdSplit& best, float plane, std::uint32_t left, std::uint32_t right) const {
        if (!(lo_ < plane && plane < hi_)) return;
        const KdSplit split{
            split_cost(sah_, chances_.left(plane), left, chances_.right(plane), right), axis_,
            plane, left > 0 || right == 0};
        if (split.better_than(best)) best = split;
    }
    /// What is all within the box is cut off from empty space.
    void cut(KdSplit& best, const Box& box, std::uint32_t all) const {
        improve(best, box.lo[axis_], 0, all);
        improve(best, box.hi[axis_], all, 0);
    }

private:
    const Sah& sah_;
    KdChances chances_;
    float lo_, hi_;
    int axis_;
};

}  // namespace

KdSplit cutting_split(const Sah& sah, const Box& cell, std::span<const Reference> references) {
    const Box box = enclosing(references);
    KdSplit best;
    for (int axis = 0; axis < 3; ++axis)
        Planes(sah, cell, axis).cut(best, box, static_cast<std::uint32_t>(references.size()));
    return best;
}

KdSplit binned_split(const Sah& sah, const Box& cell, std::span<const Reference> references) {
    const Box box = enclosing(references);
    const auto all = static_cast<std::uint32_t>(references.size());
    const Bins bins = binned(references, BinPlaces(box, sah.bins));
    KdSplit best;
    for (int axis = 0; axis < 3; ++axis) {
        const Planes planes(sah, cell, axis);
        planes.cut(best, box, all);
        const auto& starts = bins.starts[static_cast<std::size_t>(axis)];
        const auto& ends = bins.ends[static_cast<std::size_t>(axis)];
        const float width = (box.hi[axis] - box.lo[axis]) / static_cast<float>(sah.bins);
        std::uint32_t left = 0, right = all;
        for (int bin = 1; bin < sah.bins; ++bin) {
            left += starts[static_cast<std::size_t>(bin - 1)];
            right -= ends[static_cast<std::size_t>(bin - 1)];
            planes.improve(best, std::fma(static_cast<float>(bin), width, box.lo[axis]), left,
                           right);
        }
    }
    return best;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
