#include <array>

#include "accel/bsp/sah.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

using namespace simd;

constexpr std::size_t lanes = widest;
constexpr auto tag = floats<lanes>;
using V = Floats<lanes>;

V ceiling_of_tests(V count) { return hn::Ceil(hn::Mul(count, hn::Set(tag, 1.0f / tests_at_once))); }

/// The planes of one axis.
class Candidates {
public:
    Candidates(const Box& cell, int axis, std::span<const Reference> references)
        : count_(references.size()) {
        const auto i = static_cast<std::size_t>(axis);
        for (std::size_t j = 0; j < count_; ++j) {
            lo_[j] = references[j].lo[i];
            hi_[j] = -references[j].minus_hi[i];
            flat_ |= lo_[j] == hi_[j];
            for (const float plane : {lo_[j], hi_[j]}) {
                planes_[size_] = plane;
                size_ += cell.lo[axis] < plane && plane < cell.hi[axis];
            }
        }
        for (std::size_t j = size_; j % lanes != 0; ++j) planes_[j] = infinity;
    }

    void improve(KdSplit& best, const Sah& sah, const Box& cell, int axis) const {
        const KdChances chances(cell, axis);
        const V left_slope = set(static_cast<float>(chances.left_slope));
        const V lo = set(cell.lo[axis]);
        for (std::size_t i = 0; i < size_; i += lanes) {
            const V plane = hn::Load(tag, &planes_[i]);
            const V beyond = hn::Mul(hn::Sub(plane, lo), left_slope);
            const V left_chance = hn::Add(set(static_cast<float>(chances.left_at_lo)), beyond);
            const V right_chance = hn::Sub(set(static_cast<float>(chances.right_at_lo)), beyond);
            const Sides sides = count(plane);
            const V planar_left =
                cost(sah, left_chance, hn::Add(sides.left, sides.flat), right_chance, sides.right);
            const V planar_right =
                cost(sah, left_chance, sides.left, right_chance, hn::Add(sides.right, sides.flat));
            take(best, axis, i, planar_left, true);
            if (flat_) take(best, axis, i, planar_right, false);
        }
    }

private:
    struct Sides {
        V left, right, flat;
    };

    static V set(float x) { return hn::Set(tag, x); }

    Sides count(V plane) const {
        const V one = set(1);
        Sides sides{hn::Zero(tag), hn::Zero(tag), hn::Zero(tag)};
        for (std::size_t j = 0; j < count_; ++j) {
            const V lo = set(lo_[j]), hi = set(hi_[j]);
            sides.left = hn::Add(sides.left, hn::IfThenElseZero(hn::Lt(lo, plane), one));
            sides.right = hn::Add(sides.right, hn::IfThenElseZero(hn::Gt(hi, plane), one));
        }
        if (!flat_) return sides;
        for (std::size_t j = 0; j < count_; ++j) {
            const auto in_plane = hn::And(hn::Eq(set(lo_[j]), plane), hn::Eq(set(hi_[j]), plane));
            sides.flat = hn::Add(sides.flat, hn::IfThenElseZero(in_plane, one));
        }
        return sides;
    }

    static V cost(const Sah& sah, V left_chance, V left, V right_chance, V right) {
        const V tests = hn::MulAdd(left_chance, ceiling_of_tests(left),
                                   hn::Mul(right_chance, ceiling_of_tests(right)));
        const V cost = hn::MulAdd(tests, set(sah.test_cost), set(sah.step_cost));
        const V none = hn::Zero(tag);
        const auto empty = hn::Or(hn::Eq(left, none), hn::Eq(right, none));
        return hn::IfThenElse(empty, hn::Mul(cost, set(sah.empty_factor)), cost);
    }

    /// The planes from `first` on.
    void take(KdSplit& best, int axis, std::size_t first, V costs, bool planar_left) const {
        const auto promising = hn::And(hn::Le(costs, set(best.cost)),
                                       hn::Lt(hn::Load(tag, &planes_[first]), set(infinity)));
        std::uint32_t places = bits(tag, promising);
        if (places == 0) return;
        alignas(64) std::array<float, lanes> cost;
        hn::Store(costs, tag, cost.data());
        for (; places != 0; places &= places - 1) {
            const auto i = static_cast<std::size_t>(std::countr_zero(places));
            const KdSplit split{cost[i], axis, planes_[first + i], planar_left};
            if (split.better_than(best)) best = split;
        }
    }

    std::size_t count_, size_ = 0;
    bool flat_ = false;
    std::array<float, most_counted> lo_, hi_;
    alignas(64) std::array<float, 2 * most_counted + lanes> planes_;
};

}  // namespace

KdSplit counted_split(const Sah& sah, const Box& cell, std::span<const Reference> references) {
    KdSplit best;
    for (int axis = 0; axis < 3; ++axis)
        Candidates(cell, axis, references).improve(best, sah, cell, axis);
    return best;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
