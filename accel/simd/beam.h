#pragma once

#include "accel/simd/wide_box.h"

#include <utility>

/// The beam around rays that go nearly the same way.
namespace rayshoot::inline RAYSHOOT_ISA {

/// What bounds all rays of a packet in the slab form of box.h. Rounding is monotone, so whatever
/// box the beam misses, every ray of it misses, exactly.
struct Beam {
    vec3 origin_lo{infinity}, origin_hi{-infinity};
    vec3 inverse_lo{infinity}, inverse_hi{-infinity};
    std::array<std::size_t, 3> near, far;  ///< as in SlabRay: the same for all rays
    float t_min = infinity;                ///< least of all
    float nearest = -infinity;             ///< farthest of the nearest hits so far

    /// The least entry and the largest exit of any ray for each box.
    template <class Bounds>
    auto clip(const Bounds& boxes) const {
        using namespace simd;
        constexpr auto tag = floats<Bounds::width>;
        auto entry = hn::Set(tag, t_min), exit = limit(boxes, nearest);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int i = static_cast<int>(axis);
            const bool descending = near[axis] > far[axis];
            const auto lo = hn::Set(tag, inverse_lo[i]), hi = hn::Set(tag, inverse_hi[i]);
            // The origin from which a plane is met first, and the one from which it is met last.
            const auto first = hn::Set(tag, descending ? origin_lo[i] : origin_hi[i]);
            const auto last = hn::Set(tag, descending ? origin_hi[i] : origin_lo[i]);
            const auto to_near = hn::Sub(row(boxes, axis, near[axis] * Bounds::width), first);
            const auto to_far = hn::Sub(row(boxes, axis, far[axis] * Bounds::width), last);
            entry = larger(least(hn::Mul(to_near, lo), hn::Mul(to_near, hi)), entry);
            exit = smaller(most(hn::Mul(to_far, lo), hn::Mul(to_far, hi)), exit);
        }
        return std::pair(entry, exit);
    }

private:
    /// NaN where one of the two is: it bounds nothing.
    template <class V>
    static V least(V a, V b) {
        using namespace simd;
        return hn::IfThenElse(hn::Lt(a, b), a, hn::IfThenElse(hn::Ge(a, b), b, hn::Add(a, b)));
    }
    template <class V>
    static V most(V a, V b) {
        using namespace simd;
        return hn::IfThenElse(hn::Gt(a, b), a, hn::IfThenElse(hn::Le(a, b), b, hn::Add(a, b)));
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
