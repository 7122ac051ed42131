#pragma once

#include "accel/simd/triangle_block.h"

/// Several rays at once, each against a block of triangles of its own, without a branch: whether a
/// ray hits cannot be foretold, and a wrong guess costs as much as the test.
namespace rayshoot::inline RAYSHOOT_ISA {

/// As many as fill a register.
inline constexpr std::size_t rays_by_blocks = simd::widest / TriangleBlock::width;

struct RayAndBlock {
    const TestRay* ray;
    Hit* hit;
    const TriangleBlock* block;
};
using RaysAndBlocks = std::array<RayAndBlock, rays_by_blocks>;

/// A register holds a quad of lanes for each ray.
namespace quads {

inline constexpr std::size_t lanes = simd::widest;
inline constexpr auto tag = simd::floats<lanes>;
inline constexpr auto word = simd::words<lanes>;
using V = simd::Floats<lanes>;

/// The four values that `at(i)` points to for each ray i.
template <class At>
inline V load(At&& at) {
    using namespace simd;
    constexpr hn::FixedTag<float, 4> quad;
    constexpr hn::FixedTag<float, 8> pair;
    const auto two = [&](std::size_t i) {
        return hn::Combine(pair, hn::LoadU(quad, at(i + 1)), hn::LoadU(quad, at(i)));
    };
    if constexpr (lanes == 8) return two(0);
    else return hn::Combine(tag, two(2), two(0));
}

/// The first three values of each quad, each in all lanes of its quad.
inline simd::Vectors<V> vectors(V quads) {
    using namespace simd;
    return {hn::Broadcast<0>(quads), hn::Broadcast<1>(quads), hn::Broadcast<2>(quads)};
}

/// The least value of each quad, in all its lanes.
template <class Vector>
inline Vector least(Vector v) {
    using namespace simd;
    v = hn::Min(v, hn::Shuffle1032(v));
    return hn::Min(v, hn::Shuffle2301(v));
}

/// The value of those lanes of each quad that are chosen, in all its lanes; they are all equal.
inline V chosen(decltype(simd::hn::Lt(V{}, V{})) mask, V v) {
    using namespace simd;
    v = hn::IfThenElseZero(mask, v);
    v = hn::Or(v, hn::Shuffle1032(v));
    return hn::Or(v, hn::Shuffle2301(v));
}

}  // namespace quads

/// For the first `size` of them what test() of triangle_block.h does: the same bits.
template <Counter C>
inline void test(RaysAndBlocks& pairs, std::size_t size, float padding, C& count) {
    static constexpr TriangleBlock nothing;
    Hit nobody;
    for (std::size_t i = size; i < pairs.size(); ++i) pairs[i] = {pairs[0].ray, &nobody, &nothing};
    using namespace simd;
    using quads::tag, quads::word, quads::V;
    const auto corner = [&](std::size_t row) {
        return quads::load([&](std::size_t i) { return pairs[i].block->corner[row].data(); });
    };
    const auto of_rays = [&](auto&& first) {
        return quads::load([&](std::size_t i) { return first(*pairs[i].ray); });
    };
    const Vectors<V> a{corner(0), corner(1), corner(2)}, b{corner(3), corner(4), corner(5)},
        c{corner(6), corner(7), corner(8)}, e1 = b - a, e2 = c - a;
    const V origins = of_rays([](const TestRay& ray) { return &ray.origin.x; });
    const V directions = of_rays([](const TestRay& ray) { return &ray.direction.x; });
    const Vectors<V> origin = quads::vectors(origins), direction = quads::vectors(directions);
    const WideSums<V> sums(a, e1, e2, origin, direction);
    const V sizes = hn::Mul(taxicab(e1), taxicab(e2));
    const auto trusted = sums.trusted(hn::Mul(sizes, hn::Broadcast<3>(directions)));

    const Vectors<V> inverse =
        quads::vectors(of_rays([](const TestRay& ray) { return &ray.inverse.x; }));
    const auto hit = clamped<V>({hn::Div(sums.t, sums.det), hn::And(trusted, sums.inside())}, a,
                                triangle_bounds(a, b, c), origin, inverse, padding);
    const auto [t, met] = hit;

    // The nearest that is met: of equally near ones the one with the smallest number.
    const V limits = of_rays([](const TestRay& ray) { return &ray.direction_size; });
    const auto eligible = hn::And(met, hn::Gt(t, hn::Broadcast<1>(limits)));
    const V nearest = quads::least(hn::IfThenElse(eligible, t, hn::Set(tag, infinity)));
    const auto numbers = hn::BitCast(word, quads::load([&](std::size_t i) {
        return reinterpret_cast<const float*>(pairs[i].block->primitive.data());
    }));
    const auto tied = hn::And(eligible, hn::Eq(t, nearest));
    const auto number = quads::least(
        hn::IfThenElse(hn::RebindMask(word, tied), numbers, hn::Set(word, no_primitive)));
    const auto best = hn::And(tied, hn::RebindMask(tag, hn::Eq(number, numbers)));
    const V hits = quads::load([&](std::size_t i) { return &pairs[i].hit->t; });
    const V limit = hn::Broadcast<0>(hits);
    const auto limit_number = hn::BitCast(word, hn::Broadcast<1>(hits));
    const auto accepted =
        hn::Or(hn::Lt(nearest, limit),
               hn::And(hn::Eq(nearest, limit), hn::RebindMask(tag, hn::Lt(number, limit_number))));
    const V u = quads::chosen(best, hn::Div(sums.u, sums.det));
    const V v = quads::chosen(best, hn::Div(sums.v, sums.det));
    alignas(64) static constexpr std::array<std::uint32_t, 16> places{0, 1, 2, 3, 0, 1, 2, 3,
                                                                      0, 1, 2, 3, 0, 1, 2, 3};
    const auto place = hn::Load(word, places.data());
    const auto at = [&](std::uint32_t i) {
        return hn::RebindMask(tag, hn::Eq(place, hn::Set(word, i)));
    };
    const V found = hn::IfThenElse(
        at(0), nearest,
        hn::IfThenElse(at(1), hn::BitCast(tag, number), hn::IfThenElse(at(2), u, v)));
    alignas(64) std::array<Hit, rays_by_blocks> results;
    hn::Store(hn::IfThenElse(accepted, found, hits), tag, &results[0].t);
    for (std::size_t i = 0; i < pairs.size(); ++i) *pairs[i].hit = results[i];

    const auto live = hn::RebindMask(tag, hn::Ne(numbers, hn::Set(word, no_primitive)));
    if constexpr (C::counts) {
        count(Event::object_test, hn::CountTrue(tag, live));
        count(Event::object_hit, hn::CountTrue(tag, met));
    }
    const std::uint32_t untrusted = bits(tag, hn::AndNot(trusted, live));
    if (untrusted == 0) [[likely]] return;
    for (std::uint32_t rest = untrusted; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        const RayAndBlock& pair = pairs[lane / TriangleBlock::width];
        test_in_double(*pair.block, lane % TriangleBlock::width, *pair.ray, padding, *pair.hit,
                       count);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
