#pragma once

#include "accel/simd/quads.h"

/// Several rays at once, each against a block of its own or all against the same.
namespace rayshoot::inline RAYSHOOT_ISA {

/// What to do where none of the rays meets anything: leave at once, or go on, because a branch that
/// is guessed wrongly costs as much.
enum class Misses { leave, go_on };

/// Tests each ray against its four triangles as test() of triangle_block.h does, or
/// test_watertight(): the same bits; for Query::occluded of some hit instead of the nearest,
/// without t, u and v. Only the first `size` rays count, but all are given hits. `in_double(ray,
/// lane)`: for what float cannot decide. Returns false only if surely no hit has changed.
template <Query Q, Precision P, Misses M, class HitOf, class InDouble, Counter C>
[[gnu::always_inline]] inline bool test(const QuadsOfTriangles& triangles, const QuadsOfRays& rays,
                                        std::size_t size, HitOf&& hit_of, InDouble&& in_double,
                                        float padding, C& count) {
    using namespace simd;
    using quads::tag, quads::V;
    const Vectors<V>&a = triangles.a, &b = triangles.b, &c = triangles.c;
    const quads::Counted counted(size);
    const auto live = triangles.live();
    counted.count(Event::object_test, live, count);
    const auto offer = [&](V t, V u, V v, auto inside, const auto& strays)
        __attribute__((always_inline)) {
        const auto hit = clamped<V>({t, inside}, a, triangle_bounds(a, b, c), rays.origin,
                                    rays.inverse(), padding, strays);
        counted.count(Event::object_hit, hit.met, count);
        if constexpr (Q == Query::occluded)
            return accept_any(hit_of, triangles.numbers, rays.t_min, hit);
        accept_nearest(hit_of, triangles.numbers, rays.t_min, hit, u, v);
        return true;
    };
    if constexpr (P == Precision::watertight) {
        const WideShear<V> shear(rays.direction);
        const WideEdges<V> edges(shear.turned(a - rays.origin), shear.turned(b - rays.origin),
                                 shear.turned(c - rays.origin), shear.along_x, shear.along_y);
        const auto left = hn::AndNot(edges.outside(), live);
        if (M == Misses::leave && hn::AllFalse(tag, left)) return false;
        const auto at = edges.exact(shear.direction_z);
        return offer(at.t, at.u, at.v, hn::And(left, hn::Eq(at.t, at.t)), NeverStrays());
    } else {
        const Vectors<V> e1 = b - a, e2 = c - a;
        const WideSums<V> sums(a, e1, e2, rays.origin, rays.direction, rays.direction_size);
        const auto near = hn::AndNot(sums.outside(), live);
        if (M == Misses::leave && hn::AllFalse(tag, near)) return false;
        const auto trusted = sums.trusted();
        const auto inside = hn::And(hn::And(near, trusted), sums.inside());
        const std::uint32_t untrusted = counted.lanes(hn::AndNot(trusted, near));
        const bool changed =
            offer(hn::Div(sums.t, sums.det), hn::Div(sums.u, sums.det), hn::Div(sums.v, sums.det),
                  inside, StraysFromTriangle<V>{a, rays.origin, rays.direction});
        quads::each(untrusted, in_double);
        return changed || untrusted != 0;
    }
}

/// Or against its four spheres, as test() of sphere_block.h does; `in_double` likewise.
template <Misses M, class HitOf, class InDouble, Counter C>
[[gnu::always_inline]] inline bool test(const QuadsOfSpheres& spheres, const QuadsOfRays& rays,
                                        std::size_t size, HitOf&& hit_of, InDouble&& in_double,
                                        float padding, C& count) {
    using namespace simd;
    using quads::tag, quads::V;
    const quads::Counted counted(size);
    const auto live = spheres.live();
    counted.count(Event::object_test, live, count);
    const WideRoots<V> roots(spheres.centre, spheres.radius, rays.origin, rays.direction);
    const auto trusted = roots.trusted(rays.direction_size);
    const auto inside = hn::And(trusted, roots.met());
    const std::uint32_t untrusted = counted.lanes(hn::AndNot(trusted, live));
    if (M == Misses::leave && hn::AllFalse(tag, inside) && untrusted == 0) return false;
    const auto [t, met] = clamped<V>({roots.roots(), inside}, spheres.centre, spheres.radius,
                                     rays.origin, rays.inverse(), padding);
    counted.count(Event::object_hit, met, count);
    // The second root only where it comes before the first, or where the first does not count.
    const auto first_counts = hn::And(hn::Gt(t[0], rays.t_min), hn::Le(t[0], t[1]));
    const auto second = hn::AndNot(first_counts, hn::Gt(t[1], rays.t_min));
    accept_nearest(hit_of, spheres.numbers, rays.t_min, {hn::IfThenElse(second, t[1], t[0]), met},
                   hn::Zero(tag), hn::Zero(tag));
    quads::each(untrusted, in_double);
    return true;
}

/// For the first `size` of them what test() of triangle_block.h does, or test_watertight(); for
/// Query::occluded as above. Flattened, as g++ 12 leaves the sums out of line: what is handed over
/// by its address lies in memory.
template <Precision P, Misses M = Misses::go_on, Query Q = Query::closest, Counter C>
[[gnu::flatten]] inline void test(RaysAndBlocks<TriangleBlock>& pairs, std::size_t size,
                                  float padding, C& count) {
    Hit nobody;
    quads::fill(pairs, size, nobody);
    test<Q, P, M>(
        QuadsOfTriangles(pairs), QuadsOfRays(pairs), size,
        [&](std::size_t i) -> Hit& { return *pairs[i].hit; },
        [&](std::size_t i, std::size_t lane) {
            test_in_double(*pairs[i].block, lane, *pairs[i].ray, padding, *pairs[i].hit, count);
        },
        padding, count);
}

/// For the first `size` of them what test() of sphere_block.h does.
template <Misses M = Misses::go_on, Counter C>
inline void test(RaysAndBlocks<SphereBlock>& pairs, std::size_t size, float padding, C& count) {
    Hit nobody;
    quads::fill(pairs, size, nobody);
    const QuadsOfRays rays(pairs);
    bool more = true;
    for (std::size_t first = 0; more; first += 4) {
        test<M>(
            QuadsOfSpheres(pairs, first), rays, size,
            [&](std::size_t i) -> Hit& { return *pairs[i].hit; },
            [&](std::size_t i, std::size_t lane) {
                test_untrusted(*pairs[i].block, 1u << (first + lane), *pairs[i].ray, padding,
                               *pairs[i].hit, count);
            },
            padding, count);
        more = false;
        if (first == 0)
            for (const auto& pair : pairs) more |= pair.block->primitive[4] != no_primitive;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
