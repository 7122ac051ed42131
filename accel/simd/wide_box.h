#pragma once

#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/test_ray.h"
#include "accel/simd/lanes.h"

/// Stored bounds and the one slab form, in every lane: core/primitive/padding.h and core/box.h.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A box a lane, plane by plane: lo.x, lo.y, lo.z, hi.x, hi.y, hi.z.
template <class V>
using WidePlanes = std::array<V, 6>;

// What a traversal asks of a node's boxes, however they are stored.

/// The planes of all boxes that a ray meets first across an axis, or last. `first`: their place in
/// {lo.xyz, hi.xyz}, as in SlabRay, times the number of boxes.
template <std::size_t Width>
inline simd::Floats<Width> row(const Boxes<Width>& boxes, std::size_t /*axis*/, std::size_t first) {
    return simd::hn::Load(simd::floats<Width>, boxes.planes[0].data() + first);
}
/// One of these, of one box.
template <std::size_t Width>
inline float plane(const Boxes<Width>& boxes, std::size_t /*axis*/, std::size_t place,
                   std::size_t box) {
    return boxes.planes[place][box];
}
/// A ray's t_max for each box.
template <std::size_t Width>
inline simd::Floats<Width> limit(const Boxes<Width>&, float t_max) {
    return simd::hn::Set(simd::floats<Width>, t_max);
}

/// bounds(Triangle)
template <class V>
inline WidePlanes<V> triangle_bounds(const simd::Vectors<V>& a, const simd::Vectors<V>& b,
                                     const simd::Vectors<V>& c) {
    const auto lo = [](V x, V y, V z) { return simd::smaller(z, simd::smaller(y, x)); };
    const auto hi = [](V x, V y, V z) { return simd::larger(z, simd::larger(y, x)); };
    return {lo(a.x, b.x, c.x), lo(a.y, b.y, c.y), lo(a.z, b.z, c.z),
            hi(a.x, b.x, c.x), hi(a.y, b.y, c.y), hi(a.z, b.z, c.z)};
}

/// bounds(Sphere)
template <class V>
inline WidePlanes<V> sphere_bounds(const simd::Vectors<V>& centre, V radius) {
    using namespace simd;
    return {hn::Sub(centre.x, radius), hn::Sub(centre.y, radius), hn::Sub(centre.z, radius),
            hn::Add(centre.x, radius), hn::Add(centre.y, radius), hn::Add(centre.z, radius)};
}

/// padded(Box, padding)
template <class V>
inline WidePlanes<V> padded(WidePlanes<V> planes, float padding) {
    using namespace simd;
    constexpr hn::DFromV<V> tag;
    V largest = hn::Abs(planes[0]);
    for (std::size_t i = 1; i < 6; ++i) largest = hn::Max(largest, hn::Abs(planes[i]));
    const V radius = hn::MulAdd(hn::Set(tag, own_padding), largest, hn::Set(tag, padding));
    for (std::size_t i = 0; i < 3; ++i) {
        planes[i] = below(hn::Sub(planes[i], radius));
        planes[i + 3] = hn::Neg(below(hn::Neg(hn::Add(planes[i + 3], radius))));
    }
    return planes;
}

template <class V>
struct WideInterval {
    V entry, exit;

    auto met() const { return simd::hn::Le(entry, exit); }
    auto contains(V t) const {
        return simd::hn::And(simd::hn::Le(entry, t), simd::hn::Le(t, exit));
    }
    V clamp(V t) const { return simd::clamp(t, entry, exit); }
};

/// clip(SlabRay, Box); the signs of the directions may differ from lane to lane.
template <class V>
inline WideInterval<V> clip(const simd::Vectors<V>& origin, const simd::Vectors<V>& inverse,
                            const WidePlanes<V>& planes) {
    using namespace simd;
    constexpr hn::DFromV<V> tag;
    WideInterval<V> within{hn::Set(tag, -infinity), hn::Set(tag, infinity)};
    const auto narrow = [&](V lo, V hi, V from, V scale) {
        const auto descending = is_negative(scale);
        const V near = hn::IfThenElse(descending, hi, lo), far = hn::IfThenElse(descending, lo, hi);
        within = {larger(hn::Mul(hn::Sub(near, from), scale), within.entry),
                  smaller(hn::Mul(hn::Sub(far, from), scale), within.exit)};
    };
    narrow(planes[0], planes[3], origin.x, inverse.x);
    narrow(planes[1], planes[4], origin.y, inverse.y);
    narrow(planes[2], planes[5], origin.z, inverse.z);
    return within;
}

/// The interval of bounds that are padded by less than they should be: by the share of a `point` of
/// theirs instead of their largest coordinate. They nest in the padded ones, so the interval does,
/// exactly: nearly every t lies in it, and then there is nothing to clamp.
template <class V>
[[gnu::always_inline]] inline WideInterval<V> inner_interval(const simd::Vectors<V>& point,
                                                             const WidePlanes<V>& bounds,
                                                             const simd::Vectors<V>& origin,
                                                             const simd::Vectors<V>& inverse,
                                                             float padding) {
    using namespace simd;
    constexpr hn::DFromV<V> tag;
    const V largest = hn::Max(hn::Max(hn::Abs(point.x), hn::Abs(point.y)), hn::Abs(point.z));
    const V radius = hn::MulAdd(hn::Set(tag, own_padding), largest, hn::Set(tag, padding));
    WideInterval<V> within{hn::Set(tag, -infinity), hn::Set(tag, infinity)};
    const auto narrow = [&](V lo, V hi, V from, V scale) {
        const V at_lo = hn::Mul(hn::Sub(hn::Sub(lo, radius), from), scale);
        const V at_hi = hn::Mul(hn::Sub(hn::Add(hi, radius), from), scale);
        within = {hn::Max(hn::Min(at_lo, at_hi), within.entry),
                  hn::Min(hn::Max(at_lo, at_hi), within.exit)};
    };
    narrow(bounds[0], bounds[3], origin.x, inverse.x);
    narrow(bounds[1], bounds[4], origin.y, inverse.y);
    narrow(bounds[2], bounds[5], origin.z, inverse.z);
    return within;
}

template <class V>
struct WideHit {
    V t;
    decltype(simd::hn::Lt(V{}, V{})) met;
};

/// Where bounds are padded by more than the test errs by.
struct NeverStrays {
    template <class V>
    auto operator()(V /*t*/, V /*clamped*/) const {
        return simd::hn::FirstN(simd::hn::DFromV<V>(), 0);
    }
};

/// By the slab form itself, which is seldom asked: out of the way of what is.
template <class V, class Strays>
[[gnu::noinline]] WideHit<V> clamped_exactly(WideHit<V> hit, const WidePlanes<V>& bounds,
                                             const simd::Vectors<V>& origin,
                                             const simd::Vectors<V>& inverse, float padding,
                                             const Strays& strays) {
    using namespace simd;
    const WideInterval<V> within = clip(origin, inverse, padded(bounds, padding));
    const V t = within.clamp(hit.t);
    const auto met = hn::And(hn::And(hit.met, within.met()), hn::Eq(hit.t, hit.t));
    return {t, hn::AndNot(strays(hit.t, t), met)};
}

/// Rule 2 of core/README.md: t clamped to the padded bounds, and not met where these are missed, t
/// is NaN or strays(t, clamped).
template <class V, class Strays>
[[gnu::always_inline]] inline WideHit<V> clamped(WideHit<V> hit, const simd::Vectors<V>& corner,
                                                 const WidePlanes<V>& bounds,
                                                 const simd::Vectors<V>& origin,
                                                 const simd::Vectors<V>& inverse, float padding,
                                                 const Strays& strays) {
    using namespace simd;
    constexpr hn::DFromV<V> tag;
    const auto as_it_is = inner_interval(corner, bounds, origin, inverse, padding).contains(hit.t);
    if (hn::AllFalse(tag, hn::AndNot(as_it_is, hit.met))) [[likely]]
        return hit;
    // Copies: what is handed over by its address lies in memory all the time.
    const WidePlanes<V> planes = bounds;
    const Vectors<V> from = origin, scale = inverse;
    const Strays rule = strays;
    return clamped_exactly<V>(hit, planes, from, scale, padding, rule);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
