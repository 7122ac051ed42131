#pragma once

#include "accel/simd/sphere_block.h"
#include "accel/simd/watertight_block.h"

/// Several rays at once, each against a block of its own, without a branch: whether a ray hits
/// cannot be foretold, and a wrong guess costs as much as the test.
namespace rayshoot::inline RAYSHOOT_ISA {

/// As many as fill a register.
inline constexpr std::size_t rays_by_blocks = simd::widest / TriangleBlock::width;

template <class Block>
struct RayAndBlock {
    const TestRay* ray = nullptr;
    Hit* hit = nullptr;
    const Block* block = nullptr;
};
template <class Block>
using RaysAndBlocks = std::array<RayAndBlock<Block>, rays_by_blocks>;

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

/// The numbers of each ray's primitives, from one lane of the block on.
template <class Block>
inline simd::Words<lanes> numbers(const RaysAndBlocks<Block>& pairs, std::size_t first) {
    return simd::hn::BitCast(
        word, load([&](std::size_t i) {
            return reinterpret_cast<const float*>(&pairs[i].block->primitive[first]);
        }));
}

/// Whatever has no pair of its own is given one that nothing comes of.
template <class Block>
inline void fill(RaysAndBlocks<Block>& pairs, std::size_t size, Hit& nobody) {
    static constexpr Block nothing;
    for (std::size_t i = size; i < pairs.size(); ++i) pairs[i] = {pairs[0].ray, &nobody, &nothing};
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

/// Rules 3 and 4 of core/README.md for each ray: the nearest primitive that is met, of equally near
/// ones that with the smallest number, if it comes before the ray's hit so far. `u` and `v` are of
/// every lane.
template <class Block>
inline void accept_nearest(const RaysAndBlocks<Block>& pairs, simd::Words<quads::lanes> numbers,
                           quads::V t_min, const WideHit<quads::V>& hit, quads::V u, quads::V v) {
    using namespace simd;
    using quads::tag, quads::word, quads::V;
    const auto eligible = hn::And(hit.met, hn::Gt(hit.t, t_min));
    const V t = quads::least(hn::IfThenElse(eligible, hit.t, hn::Set(tag, infinity)));
    const auto tied = hn::And(eligible, hn::Eq(hit.t, t));
    const auto number = quads::least(
        hn::IfThenElse(hn::RebindMask(word, tied), numbers, hn::Set(word, no_primitive)));
    const auto nearest = hn::And(tied, hn::RebindMask(tag, hn::Eq(number, numbers)));
    const V before = quads::load([&](std::size_t i) { return &pairs[i].hit->t; });
    const V t_before = hn::Broadcast<0>(before);
    const auto number_before = hn::BitCast(word, hn::Broadcast<1>(before));
    const auto smaller_number = hn::RebindMask(tag, hn::Lt(number, number_before));
    const auto accepted = hn::Or(hn::Lt(t, t_before), hn::And(hn::Eq(t, t_before), smaller_number));
    const auto place = hn::And(hn::Iota(word, 0), hn::Set(word, 3));
    const auto at = [&](std::uint32_t i) {
        return hn::RebindMask(tag, hn::Eq(place, hn::Set(word, i)));
    };
    // Its own t: that of another may be the other zero.
    const V found = hn::IfThenElse(at(0), quads::chosen(nearest, hit.t),
                                   hn::IfThenElse(at(1), hn::BitCast(tag, number),
                                                  hn::IfThenElse(at(2), quads::chosen(nearest, u),
                                                                 quads::chosen(nearest, v))));
    alignas(64) std::array<Hit, rays_by_blocks> hits;
    hn::Store(hn::IfThenElse(accepted, found, before), tag, &hits[0].t);
    for (std::size_t i = 0; i < pairs.size(); ++i) *pairs[i].hit = hits[i];
}

/// The rays, each in all lanes of its quad.
struct QuadsOfRays {
    simd::Vectors<quads::V> origin, direction, inverse;
    quads::V direction_size, t_min;

    template <class Block>
    explicit QuadsOfRays(const RaysAndBlocks<Block>& pairs) {
        using namespace simd;
        const auto load = [&](auto&& first) {
            return quads::load([&](std::size_t i) { return first(*pairs[i].ray); });
        };
        const quads::V directions = load([](const TestRay& ray) { return &ray.direction.x; });
        const quads::V sizes = load([](const TestRay& ray) { return &ray.direction_size; });
        origin = quads::vectors(load([](const TestRay& ray) { return &ray.origin.x; }));
        direction = quads::vectors(directions);
        inverse = quads::vectors(load([](const TestRay& ray) { return &ray.inverse.x; }));
        direction_size = hn::Broadcast<0>(sizes);
        t_min = hn::Broadcast<1>(sizes);  // it follows the size
    }
};

/// For the first `size` of them what test() of triangle_block.h does, or test_watertight(): the
/// same bits.
template <Precision P, Counter C>
inline void test(RaysAndBlocks<TriangleBlock>& pairs, std::size_t size, float padding, C& count) {
    using namespace simd;
    using quads::tag, quads::word, quads::V;
    Hit nobody;
    quads::fill(pairs, size, nobody);
    const auto corner = [&](std::size_t row) {
        return quads::load([&](std::size_t i) { return pairs[i].block->corner[row].data(); });
    };
    const Vectors<V> a{corner(0), corner(1), corner(2)}, b{corner(3), corner(4), corner(5)},
        c{corner(6), corner(7), corner(8)};
    const QuadsOfRays rays(pairs);
    const auto numbers = quads::numbers(pairs, 0);
    const auto live = hn::RebindMask(tag, hn::Ne(numbers, hn::Set(word, no_primitive)));
    if constexpr (C::counts) count(Event::object_test, hn::CountTrue(tag, live));
    const auto offer = [&](V t, V u, V v, auto inside) {
        const auto hit = clamped<V>({t, inside}, a, triangle_bounds(a, b, c), rays.origin,
                                    rays.inverse, padding);
        if constexpr (C::counts) count(Event::object_hit, hn::CountTrue(tag, hit.met));
        accept_nearest(pairs, numbers, rays.t_min, hit, u, v);
    };
    if constexpr (P == Precision::watertight) {
        const WideShear<V> shear(rays.direction);
        const WideEdges<V> edges(shear.turned(a - rays.origin), shear.turned(b - rays.origin),
                                 shear.turned(c - rays.origin), shear.along_x, shear.along_y);
        const auto at = edges.exact(shear.direction_z);
        const auto left = hn::AndNot(edges.outside(), live);
        offer(at.t, at.u, at.v, hn::And(left, hn::Eq(at.t, at.t)));
    } else {
        const Vectors<V> e1 = b - a, e2 = c - a;
        const WideSums<V> sums(a, e1, e2, rays.origin, rays.direction);
        const V sizes = hn::Mul(taxicab(e1), taxicab(e2));
        const auto trusted = sums.trusted(hn::Mul(sizes, rays.direction_size));
        offer(hn::Div(sums.t, sums.det), hn::Div(sums.u, sums.det), hn::Div(sums.v, sums.det),
              hn::And(trusted, sums.inside()));
        const std::uint32_t untrusted = bits(tag, hn::AndNot(trusted, live));
        for (std::uint32_t rest = untrusted; rest != 0; rest &= rest - 1) [[unlikely]] {
                const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
                const auto& pair = pairs[lane / 4];
                test_in_double(*pair.block, lane % 4, *pair.ray, padding, *pair.hit, count);
            }
    }
}

/// Four spheres of each block, from one lane on.
template <Counter C>
inline void test_spheres(const RaysAndBlocks<SphereBlock>& pairs, std::size_t first, float padding,
                         C& count) {
    using namespace simd;
    using quads::tag, quads::word, quads::V;
    const auto values = [&](auto&& row) {
        return quads::load([&](std::size_t i) { return &row(*pairs[i].block)[first]; });
    };
    const auto coordinates = [&](std::size_t axis) {
        return values([&](const SphereBlock& block) -> auto& { return block.centre[axis]; });
    };
    const Vectors<V> centre{coordinates(0), coordinates(1), coordinates(2)};
    const V radius = values([](const SphereBlock& block) -> auto& { return block.radius; });
    const QuadsOfRays rays(pairs);
    const auto numbers = quads::numbers(pairs, first);
    const auto live = hn::RebindMask(tag, hn::Ne(numbers, hn::Set(word, no_primitive)));
    const WideRoots<V> sphere(centre, radius, rays.origin, rays.direction);
    const auto trusted = sphere.trusted(rays.direction_size);
    const auto [t, met] = clamped<V>({sphere.roots(), hn::And(trusted, sphere.met())}, centre,
                                     radius, rays.origin, rays.inverse, padding);
    if constexpr (C::counts) {
        count(Event::object_test, hn::CountTrue(tag, live));
        count(Event::object_hit, hn::CountTrue(tag, met));
    }
    // The second root only where it comes before the first, or where the first does not count.
    const auto first_counts = hn::And(hn::Gt(t[0], rays.t_min), hn::Le(t[0], t[1]));
    const auto second = hn::AndNot(first_counts, hn::Gt(t[1], rays.t_min));
    accept_nearest(pairs, numbers, rays.t_min, {hn::IfThenElse(second, t[1], t[0]), met},
                   hn::Zero(tag), hn::Zero(tag));
    const std::uint32_t untrusted = bits(tag, hn::AndNot(trusted, live));
    for (std::uint32_t rest = untrusted; rest != 0; rest &= rest - 1) [[unlikely]] {
            const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
            const auto& pair = pairs[lane / 4];
            test_untrusted(*pair.block, 1u << (first + lane % 4), *pair.ray, padding, *pair.hit,
                           count);
        }
}

/// For the first `size` of them what test() of sphere_block.h does: the same bits.
template <Counter C>
inline void test(RaysAndBlocks<SphereBlock>& pairs, std::size_t size, float padding, C& count) {
    Hit nobody;
    quads::fill(pairs, size, nobody);
    test_spheres(pairs, 0, padding, count);
    bool more = false;
    for (const auto& pair : pairs) more |= pair.block->primitive[4] != no_primitive;
    if (more) test_spheres(pairs, 4, padding, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
