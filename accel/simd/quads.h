#pragma once

#include "accel/simd/sphere_block.h"
#include "accel/simd/watertight_block.h"

/// Several rays, each with four primitives of a block of its own or of the same for all, side by
/// side in one register.
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

/// The same four values for each ray.
inline V repeat(const float* at) { return simd::hn::LoadDup128(tag, at); }

/// `as_numbers`: of primitives, as a load or repeat gives them.
inline simd::Words<lanes> as_numbers(V loaded) { return simd::hn::BitCast(word, loaded); }
inline const float* numbers_from(const std::uint32_t& first) {
    return reinterpret_cast<const float*>(&first);
}

/// Where there are not as many pairs: an empty block.
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

/// The lanes of the first `size` rays, which alone count.
class Counted {
public:
    explicit Counted(std::size_t size) : lanes_((1u << 4 * size) - 1) {}
    template <class Mask>
    std::uint32_t lanes(Mask mask) const {
        return simd::bits(tag, mask) & lanes_;
    }
    template <class Mask, Counter C>
    void count(Event event, Mask mask, C& count) const {
        if constexpr (C::counts)
            count(event, static_cast<std::uint64_t>(std::popcount(lanes(mask))));
    }

private:
    std::uint32_t lanes_;
};

/// Calls visit(ray, lane of its quad) for each of some lanes; there are seldom any.
template <class Visit>
inline void each(std::uint32_t set, Visit&& visit) {
    if (set != 0) [[unlikely]]
        simd::for_each(set, [&](std::size_t lane) { visit(lane / 4, lane % 4); });
}

}  // namespace quads

/// Rules 3 and 4 of core/README.md for each ray: the nearest primitive that is met, of equally near
/// ones that with the smallest number, if it comes before the ray's hit so far. `u` and `v` are of
/// every lane; hit_of(i) is the ray's hit so far.
template <class HitOf>
inline void accept_nearest(HitOf&& hit_of, simd::Words<quads::lanes> numbers, quads::V t_min,
                           const WideHit<quads::V>& hit, quads::V u, quads::V v) {
    using namespace simd;
    using quads::tag, quads::word, quads::V;
    const auto eligible = hn::And(hit.met, hn::Gt(hit.t, t_min));
    const V t = quads::least(hn::IfThenElse(eligible, hit.t, hn::Set(tag, infinity)));
    const auto tied = hn::And(eligible, hn::Eq(hit.t, t));
    const auto number = quads::least(
        hn::IfThenElse(hn::RebindMask(word, tied), numbers, hn::Set(word, no_primitive)));
    const auto nearest = hn::And(tied, hn::RebindMask(tag, hn::Eq(number, numbers)));
    const V before = quads::load([&](std::size_t i) { return &hit_of(i).t; });
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
    for (std::size_t i = 0; i < hits.size(); ++i) hit_of(i) = hits[i];
}

/// For rays that are over once they hit anything: any primitive that is met before the hit so far,
/// whose t stays. Returns false if no hit has changed.
template <class HitOf>
inline bool accept_any(HitOf&& hit_of, simd::Words<quads::lanes> numbers, quads::V t_min,
                       const WideHit<quads::V>& hit) {
    using namespace simd;
    using quads::tag, quads::word;
    const quads::V before =
        hn::Broadcast<0>(quads::load([&](std::size_t i) { return &hit_of(i).t; }));
    const std::uint32_t accepted =
        bits(tag, hn::And(hit.met, hn::And(hn::Gt(hit.t, t_min), hn::Le(hit.t, before))));
    if (accepted == 0) return false;
    alignas(64) std::array<std::uint32_t, quads::lanes> number_of;
    hn::Store(numbers, word, number_of.data());
    for_each(accepted, [&](std::size_t lane) { hit_of(lane / 4).primitive = number_of[lane]; });
    return true;
}

/// The rays, each in all lanes of its quad.
struct QuadsOfRays {
    simd::Vectors<quads::V> origin, direction;
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
        direction_size = hn::Broadcast<0>(sizes);
        t_min = hn::Broadcast<1>(sizes);  // it follows the size
    }
    explicit QuadsOfRays(const std::array<const Ray*, rays_by_blocks>& rays) {
        using namespace simd;
        static_assert(offsetof(Ray, t_min) == 12 && offsetof(Ray, t_max) == 28);
        const quads::V origins = quads::load([&](std::size_t i) { return &rays[i]->origin.x; });
        const quads::V directions =
            quads::load([&](std::size_t i) { return &rays[i]->direction.x; });
        origin = quads::vectors(origins);
        direction = quads::vectors(directions);
        direction_size = taxicab(direction);
        t_min = hn::Broadcast<3>(origins);
    }
    /// Of the direction; seldom needed.
    simd::Vectors<quads::V> inverse() const {
        using namespace simd;
        const quads::V one = hn::Set(quads::tag, 1.0f);
        return {hn::Div(one, direction.x), hn::Div(one, direction.y), hn::Div(one, direction.z)};
    }
};

/// Four triangles for each ray.
struct QuadsOfTriangles {
    simd::Vectors<quads::V> a, b, c;
    simd::Words<quads::lanes> numbers;

    /// Each ray's own.
    explicit QuadsOfTriangles(const RaysAndBlocks<TriangleBlock>& pairs)
        : QuadsOfTriangles([&](auto&& row) {
              return quads::load([&](std::size_t i) { return row(*pairs[i].block); });
          }) {}
    /// The same for all.
    explicit QuadsOfTriangles(const TriangleBlock& block)
        : QuadsOfTriangles([&](auto&& row) { return quads::repeat(row(block)); }) {}

    auto live() const {
        using namespace simd;
        return hn::RebindMask(quads::tag, hn::Ne(numbers, hn::Set(quads::word, no_primitive)));
    }

private:
    template <class Load>
    requires std::invocable<Load, const float* (*)(const TriangleBlock&)>
    explicit QuadsOfTriangles(Load&& load) {
        const auto corner = [&](std::size_t row) {
            return load([row](const TriangleBlock& block) { return block.corner[row].data(); });
        };
        a = {corner(0), corner(1), corner(2)};
        b = {corner(3), corner(4), corner(5)};
        c = {corner(6), corner(7), corner(8)};
        numbers = quads::as_numbers(load(
            [](const TriangleBlock& block) { return quads::numbers_from(block.primitive[0]); }));
    }
};

/// Four spheres for each ray, from one lane of the block on.
struct QuadsOfSpheres {
    simd::Vectors<quads::V> centre;
    quads::V radius;
    simd::Words<quads::lanes> numbers;

    /// Each ray's own.
    QuadsOfSpheres(const RaysAndBlocks<SphereBlock>& pairs, std::size_t first)
        : QuadsOfSpheres(first, [&](auto&& row) {
              return quads::load([&](std::size_t i) { return row(*pairs[i].block); });
          }) {}
    /// The same for all.
    QuadsOfSpheres(const SphereBlock& block, std::size_t first)
        : QuadsOfSpheres(first, [&](auto&& row) { return quads::repeat(row(block)); }) {}

    auto live() const {
        using namespace simd;
        return hn::RebindMask(quads::tag, hn::Ne(numbers, hn::Set(quads::word, no_primitive)));
    }

private:
    template <class Load>
    QuadsOfSpheres(std::size_t first, Load&& load) {
        const auto coordinate = [&](std::size_t axis) {
            return load([=](const SphereBlock& block) { return &block.centre[axis][first]; });
        };
        centre = {coordinate(0), coordinate(1), coordinate(2)};
        radius = load([=](const SphereBlock& block) { return &block.radius[first]; });
        numbers = quads::as_numbers(load(
            [=](const SphereBlock& block) { return quads::numbers_from(block.primitive[first]); }));
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
