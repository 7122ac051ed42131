#pragma once

#include "accel/simd/triangle_block.h"

/// Spheres side by side, tested against one ray at once by the arithmetic of
/// core/primitive/sphere.h, product-sum by product-sum, so that the answers are the same bits.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Up to eight spheres that stand still; lanes from the first one without a primitive on are empty.
/// As large as a block of four triangles.
struct alignas(32) SphereBlock {
    static constexpr std::size_t width = 8;
    using Row = std::array<float, width>;

    std::array<Row, 3> centre{};
    Row radius{};
    std::array<std::uint32_t, width> primitive{};

    constexpr SphereBlock() { primitive.fill(no_primitive); }
    void set(std::size_t lane, const Sphere& sphere, std::uint32_t number) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            centre[axis][lane] = sphere.centre[static_cast<int>(axis)];
        radius[lane] = sphere.radius;
        primitive[lane] = number;
    }
    Sphere sphere(std::size_t lane) const {
        return {{centre[0][lane], centre[1][lane], centre[2][lane]}, radius[lane]};
    }
    std::size_t live() const { return live_count(primitive); }
};

/// intersect_sphere<float> in every lane, and the range in which it is to be trusted.
template <class V>
class WideRoots {
public:
    WideRoots(const simd::Vectors<V>& centre, V radius, const simd::Vectors<V>& origin,
              const simd::Vectors<V>& direction)
        : from_centre_(origin - centre), radius_(radius), direction_(direction) {
        using namespace simd;
        a_ = dot(direction_, direction_);
        b_ = hn::Neg(dot(from_centre_, direction_));
        const V foot = hn::Div(b_, a_);
        const Vectors<V> nearest{hn::MulAdd(foot, direction.x, from_centre_.x),
                                 hn::MulAdd(foot, direction.y, from_centre_.y),
                                 hn::MulAdd(foot, direction.z, from_centre_.z)};
        discriminant_ = hn::MulSub(radius_, radius_, dot(nearest, nearest));
    }
    auto met() const { return simd::hn::Ge(discriminant_, all(0)); }
    /// `direction_size`: taxicab length.
    auto trusted(V direction_size) const {
        using namespace simd;
        const V distance = taxicab(from_centre_);
        const auto not_small = hn::And(hn::Gt(radius_, all(shortest_float_length)),
                                       hn::Gt(direction_size, all(shortest_float_length)));
        const auto not_large = hn::And(hn::Lt(distance, all(longest_float_length)),
                                       hn::Lt(direction_size, all(longest_float_length)));
        const auto near = hn::Lt(distance, hn::Mul(all(most_float_radii), radius_));
        return hn::And(near, hn::And(not_small, not_large));
    }
    /// Either may be NaN.
    std::array<V, 2> roots() const {
        using namespace simd;
        const V root = hn::Sqrt(hn::Mul(a_, discriminant_));
        const V q = hn::Add(b_, hn::CopySign(root, b_));
        const V c = hn::NegMulAdd(radius_, radius_, dot(from_centre_, from_centre_));
        return {hn::Div(c, q), hn::Div(q, a_)};
    }

private:
    static V all(float x) { return simd::hn::Set(simd::hn::DFromV<V>(), x); }

    simd::Vectors<V> from_centre_;
    V radius_;
    simd::Vectors<V> direction_;
    V a_, b_, discriminant_;
};

/// Spheres of a block that a ray's line meets, by rules 1 and 2 of core/README.md.
struct RootsAnswer {
    std::uint32_t met;        ///< lanes whose sphere is met
    std::uint32_t untrusted;  ///< lanes that double has to decide
    std::array<SphereBlock::Row, 2> t;
};

template <class V>
struct WideTwoHits {
    std::array<V, 2> t;
    decltype(simd::hn::Lt(V{}, V{})) met;
};

/// clamped() of wide_box.h for both roots.
template <class V>
inline WideTwoHits<V> clamped(WideTwoHits<V> hits, const simd::Vectors<V>& centre, V radius,
                              const simd::Vectors<V>& origin, const simd::Vectors<V>& inverse,
                              float padding) {
    using namespace simd;
    constexpr hn::DFromV<V> tag;
    const auto [first, second] = hits.t;
    const WidePlanes<V> bounds = sphere_bounds(centre, radius);
    const auto inner = inner_interval(centre, bounds, origin, inverse, padding);
    const auto as_they_are = hn::And(inner.contains(first), inner.contains(second));
    if (hn::AllFalse(tag, hn::AndNot(as_they_are, hits.met))) [[likely]]
        return hits;
    const WideInterval<V> within = clip(origin, inverse, padded(bounds, padding));
    const auto exists = hn::Or(hn::Eq(first, first), hn::Eq(second, second));
    return {{within.clamp(first), within.clamp(second)},
            hn::And(hits.met, hn::And(within.met(), exists))};
}

inline RootsAnswer intersect(const SphereBlock& block, const TestRay& ray, float padding) {
    using namespace simd;
    constexpr std::size_t width = SphereBlock::width;
    constexpr auto tag = floats<width>;
    using V = Floats<width>;
    const Vectors<V> centre{hn::Load(tag, block.centre[0].data()),
                            hn::Load(tag, block.centre[1].data()),
                            hn::Load(tag, block.centre[2].data())};
    const V radius = hn::Load(tag, block.radius.data());
    const WideRoots<V> sphere(centre, radius, everywhere<width>(ray.origin),
                              everywhere<width>(ray.direction));
    const auto trusted = sphere.trusted(hn::Set(tag, ray.direction_size));
    const auto inside = hn::And(trusted, sphere.met());
    RootsAnswer answer;
    answer.met = bits(tag, inside);
    answer.untrusted = bits(tag, hn::AndNot(trusted, live_lanes(tag, block.primitive)));
    if (answer.met == 0) return answer;
    const auto hits =
        clamped<V>({sphere.roots(), inside}, centre, radius, everywhere<width>(ray.origin),
                   everywhere<width>(ray.inverse), padding);
    answer.met = bits(tag, hits.met);
    hn::StoreU(hits.t[0], tag, answer.t[0].data());
    hn::StoreU(hits.t[1], tag, answer.t[1].data());
    return answer;
}

/// Spheres that are very small, large or far away, one by one.
template <Counter C>
[[gnu::noinline]] void test_untrusted(const SphereBlock& block, std::uint32_t lanes,
                                      const TestRay& ray, float padding, Hit& hit, C& count) {
    for (std::uint32_t rest = lanes; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        const Sphere sphere = block.sphere(lane);
        const Box box = padded(bounds(sphere), padding);
        bool met = false;
        meet(sphere, ray, [&](float t, float u, float v, auto&& strays) {
            met |= offer(t, u, v, block.primitive[lane], box, ray, hit, strays);
        });
        if constexpr (C::counts) count(Event::object_hit, met);
    }
}

/// Tests every sphere of the block, as Leaves::test would one after the other.
template <Counter C>
inline void test(const SphereBlock& block, const TestRay& ray, float padding, Hit& hit, C& count) {
    const RootsAnswer answer = intersect(block, ray, padding);
    if constexpr (C::counts) {
        count(Event::object_test, block.live());
        count(Event::object_hit, static_cast<std::uint64_t>(std::popcount(answer.met)));
    }
    for (std::uint32_t rest = answer.met; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        // A root that does not exist is NaN, and no NaN is accepted.
        accept({answer.t[0][lane], block.primitive[lane], 0, 0}, ray.t_min, hit);
        accept({answer.t[1][lane], block.primitive[lane], 0, 0}, ray.t_min, hit);
    }
    if (answer.untrusted != 0) [[unlikely]]
        test_untrusted(block, answer.untrusted, ray, padding, hit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
