#pragma once

#include "accel/bvh/binned_sah.h"
#include "accel/bvh/reference.h"

#include <bit>

/// Boxes sorted into bins by their centres, on all three axes at once, and the best split between
/// two bins (Wald 2007).
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where centres fall among the bins; the same expression bins and partitions.
class BinPlaces {
public:
    /// A bin on each axis, as the last bits of a float: see zero_bin.
    using Places = simd::Floats<4>;

    /// Bin 0. Its neighbours are the bins 1, 2, ...: adding it to a place rounds that to a bin.
    static constexpr float zero_bin = 0x1p23f;
    static std::size_t number(float place) { return std::bit_cast<std::uint32_t>(place) & 0xffff; }

    BinPlaces(const simd::Bounds& centres, int bins)
        : lo_(centres.lo()), last_(simd::hn::Set(tag, static_cast<float>(bins - 1))) {
        using namespace simd;
        const auto scale = hn::Div(hn::Set(tag, static_cast<float>(bins)), centres.size());
        // An axis without extent, or an infinite one, keeps all in its first bin.
        const auto usable = hn::And(hn::Gt(scale, hn::Zero(tag)), hn::IsFinite(scale));
        scale_ = hn::IfThenElseZero(usable, scale);
    }

    Places of_centre(const simd::Bounds& centre) const {
        using namespace simd;
        const auto place = hn::MulSub(hn::Sub(centre.lo(), lo_), scale_, hn::Set(tag, 0.5f));
        const auto within = smaller(larger(place, hn::Zero(tag)), last_);
        return hn::Add(within, hn::Set(tag, zero_bin));
    }

private:
    static constexpr simd::hn::FixedTag<float, 4> tag{};
    simd::Floats<4> lo_, scale_, last_;
};

/// Which side of a plane between bins a box is on.
class Side {
public:
    Side(const BinPlaces& places, int axis, int bin) : places_(places) {
        std::array<float, 4> middle{};  // on the other axes nothing is less
        middle[static_cast<std::size_t>(axis)] = BinPlaces::zero_bin + static_cast<float>(bin);
        middle_ = simd::hn::LoadU(tag, middle.data());
    }
    bool is_left(const simd::Bounds& centre) const {
        return !simd::hn::AllFalse(tag, simd::hn::Lt(places_.of_centre(centre), middle_));
    }

private:
    static constexpr simd::hn::FixedTag<float, 4> tag{};
    BinPlaces places_;
    BinPlaces::Places middle_;
};

struct Split {
    int axis = -1;  ///< -1: none
    int bin = 0;    ///< first bin of the right side
    float cost = infinity;
    std::uint32_t left_count = 0;
    simd::Bounds left, right;
};

class Bins {
public:
    explicit Bins(int bins)
        : size_(static_cast<std::size_t>(bins)), padded_((size_ + step - 2) / step * step + 1) {
        for (Axis& axis : axes_)
            for (std::size_t i = 0; i < padded_; ++i) axis[i].clear();
    }
    Bins(const Bins& other) : size_(other.size_), padded_(other.padded_) { copy(other); }
    Bins& operator=(const Bins& other) {
        size_ = other.size_;
        padded_ = other.padded_;
        copy(other);
        return *this;
    }

    /// From both halves in turn: neighbours in the order often share a bin, and would wait for each
    /// other.
    void add(std::span<const Reference> references, const BinPlaces& places) {
        const std::size_t half = references.size() / 2;
        for (std::size_t i = 0; i < half; ++i) {
            add(references[i], places);
            add(references[half + i], places);
        }
        if (references.size() % 2 != 0) add(references.back(), places);
    }

    void include(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < size_; ++i)
                axes_[axis][i].add(other.axes_[axis][i].bounds(), other.axes_[axis][i].count);
    }

    /// The cheapest split of a node of that half-area.
    Split best_split(float area, const BinnedSah& settings) const {
        Best best;
        for (int axis = 0; axis < 3; ++axis) sweep(axis, settings.test_width, best);
        Split split = best.split();
        if (split.axis < 0) return split;
        if (area > 0) split.cost /= area;
        split.cost = settings.step_cost + settings.test_cost * split.cost;
        const Axis& axis = axes_[static_cast<std::size_t>(split.axis)];
        const auto middle = static_cast<std::size_t>(split.bin);
        for (std::size_t i = 0; i < middle; ++i) {
            split.left.include(axis[i].bounds());
            split.left_count += axis[i].count;
        }
        for (std::size_t i = middle; i < size_; ++i) split.right.include(axis[i].bounds());
        return split;
    }

private:
    static constexpr std::size_t step = 4;  ///< splits whose costs are computed at once
    static constexpr std::size_t most = BinnedSah::most_bins + step;

    struct alignas(64) Bin {
        simd::Bounds::Stored stored;
        std::uint32_t count;

        simd::Bounds bounds() const { return simd::Bounds(stored); }
        void clear() {
            simd::Bounds().store(stored);
            count = 0;
        }
        void add(const simd::Bounds& box, std::uint32_t boxes) {
            simd::Bounds sum = bounds();
            sum.include(box);
            sum.store(stored);
            count += boxes;
        }
    };
    using Axis = std::array<Bin, most>;

    /// The least of the costs offered, and where; the first one of equals.
    class Best {
    public:
        /// Of the splits at `place` and the three that follow.
        void offer(simd::Floats<4> costs, int place) {
            using namespace simd;
            const auto here = hn::Iota(hn::FixedTag<std::int32_t, 4>(), place);
            const auto less = hn::Lt(costs, costs_);
            costs_ = hn::IfThenElse(less, costs, costs_);
            places_ = hn::IfThenElse(hn::RebindMask(hn::FixedTag<std::int32_t, 4>(), less), here,
                                     places_);
        }
        Split split() const {
            using namespace simd;
            std::array<float, step> costs;
            std::array<std::int32_t, step> places;
            hn::StoreU(costs_, floats<4>, costs.data());
            hn::StoreU(places_, hn::FixedTag<std::int32_t, 4>(), places.data());
            std::size_t least = 0;
            for (std::size_t j = 1; j < step; ++j)
                if (std::pair(costs[j], places[j]) < std::pair(costs[least], places[least]))
                    least = j;
            Split split;
            split.cost = costs[least];
            if (split.cost < infinity) {
                split.axis = places[least] / BinnedSah::most_bins;
                split.bin = places[least] % BinnedSah::most_bins;
            }
            return split;
        }

    private:
        simd::Floats<4> costs_ = simd::hn::Set(simd::floats<4>, infinity);
        simd::hn::Vec<simd::hn::FixedTag<std::int32_t, 4>> places_ =
            simd::hn::Zero(simd::hn::FixedTag<std::int32_t, 4>());
    };

    void add(const Reference& reference, const BinPlaces& places) {
        using namespace simd;
        const Bounds box = reference.bounds();
        alignas(16) std::array<float, 4> place;
        hn::Store(places.of_centre(box.centre()), floats<4>, place.data());
        for (std::size_t axis = 0; axis < 3; ++axis)
            axes_[axis][BinPlaces::number(place[axis])].add(box, 1);
    }

    void copy(const Bins& other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            std::copy_n(other.axes_[axis].begin(), padded_, axes_[axis].begin());
    }

    /// From the right for the bounds of all right sides, from the left for the costs.
    void sweep(int number, std::uint32_t test_width, Best& best) const {
        using namespace simd;
        const Axis& axis = axes_[static_cast<std::size_t>(number)];
        std::array<Bounds::Stored, most> right;
        std::array<std::uint32_t, most> right_count;
        Bounds side;
        std::uint32_t count = 0;
        for (std::size_t i = padded_; i-- > 1;) {
            side.include(axis[i].bounds());
            side.store(right[i]);
            right_count[i] = count += axis[i].count;
        }
        const std::uint32_t all = count + axis[0].count;
        side = {};
        for (std::size_t i = 1; i < padded_; i += step) {
            std::array<Bounds, step> left;
            for (std::size_t j = 0; j < step; ++j) {
                side.include(axis[i + j - 1].bounds());
                left[j] = side;
            }
            const auto costs = hn::Mul(half_areas(left, &right[i]),
                                       tests(all, right_count.data() + i, test_width));
            best.offer(hn::Add(hn::LowerHalf(costs), hn::UpperHalf(floats<4>, costs)),
                       number * BinnedSah::most_bins + static_cast<int>(i));
        }
    }

    /// Of four left sides, then of four right sides. Infinite where a side is empty, so that its
    /// cost (no tests) becomes NaN, which is less than nothing.
    static simd::Floats<8> half_areas(const std::array<simd::Bounds, step>& left,
                                      const simd::Bounds::Stored* right) {
        using namespace simd;
        constexpr auto tag = floats<8>;
        constexpr hn::FixedTag<double, 4> pairs;
        std::array<Floats<8>, step> sizes;  // x, y, z, 0 of the left, then of the right side
        for (std::size_t j = 0; j < step; ++j) {
            const auto l = left[j].planes(), r = Bounds(right[j]).planes();
            sizes[j] = hn::Add(hn::ConcatLowerLower(tag, r, l), hn::ConcatUpperUpper(tag, r, l));
        }
        const auto xy01 = hn::BitCast(pairs, hn::InterleaveLower(tag, sizes[0], sizes[1]));
        const auto xy23 = hn::BitCast(pairs, hn::InterleaveLower(tag, sizes[2], sizes[3]));
        const auto z01 = hn::BitCast(pairs, hn::InterleaveUpper(tag, sizes[0], sizes[1]));
        const auto z23 = hn::BitCast(pairs, hn::InterleaveUpper(tag, sizes[2], sizes[3]));
        const auto x = hn::BitCast(tag, hn::InterleaveLower(pairs, xy01, xy23));
        const auto y = hn::BitCast(tag, hn::InterleaveUpper(pairs, xy01, xy23));
        const auto z = hn::BitCast(tag, hn::InterleaveLower(pairs, z01, z23));
        return hn::MulAdd(x, y, hn::MulAdd(y, z, hn::Mul(z, x)));
    }

    /// Of both sides, as above.
    static simd::Floats<8> tests(std::uint32_t all, const std::uint32_t* right_counts,
                                 std::uint32_t test_width) {
        using namespace simd;
        constexpr hn::FixedTag<std::int32_t, 8> number;
        const auto right = hn::LoadU(words<4>, right_counts);
        const auto left = hn::Sub(hn::Set(words<4>, all), right);
        const auto rounded_up =
            hn::Add(hn::Combine(words<8>, right, left), hn::Set(words<8>, test_width - 1));
        const auto tests = hn::ShiftRightSame(rounded_up, std::countr_zero(test_width));
        return hn::ConvertTo(floats<8>, hn::BitCast(number, tests));
    }

    std::size_t size_, padded_;
    std::array<Axis, 3> axes_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
