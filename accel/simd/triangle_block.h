#pragma once

#include "accel/core/leaves.h"
#include "accel/simd/lanes.h"

#include <bit>

/// Triangles side by side, tested against one ray at once by the arithmetic of
/// core/primitive/triangle.h, product-sum by product-sum, so that the answers are the same bits.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Up to four triangles that stand still; lanes from the first one without a primitive on are
/// empty.
struct alignas(32) TriangleBlock {
    static constexpr std::size_t width = 4;
    using Row = std::array<float, width>;

    std::array<Row, 9> corner{};  ///< a.x, a.y, a.z, b.x, ..., c.z
    std::array<std::uint32_t, width> primitive{no_primitive, no_primitive, no_primitive,
                                               no_primitive};

    void set(std::size_t lane, const Triangle& triangle, std::uint32_t number) {
        std::size_t row = 0;
        for (const vec3& p : {triangle.a, triangle.b, triangle.c})
            for (int axis = 0; axis < 3; ++axis) corner[row++][lane] = p[axis];
        primitive[lane] = number;
    }
    Triangle triangle(std::size_t lane) const {
        const auto& at = corner;
        return {{at[0][lane], at[1][lane], at[2][lane]},
                {at[3][lane], at[4][lane], at[5][lane]},
                {at[6][lane], at[7][lane], at[8][lane]}};
    }
    std::size_t live() const {
        std::size_t count = 0;
        for (const std::uint32_t number : primitive) count += number != no_primitive;
        return count;
    }
};

/// TriangleSums and the float test's conditions in every lane.
template <class V>
struct WideSums {
    V det, u, v, t;

    WideSums(const simd::Vectors<V>& a, const simd::Vectors<V>& e1, const simd::Vectors<V>& e2,
             const simd::Vectors<V>& origin, const simd::Vectors<V>& direction) {
        using namespace simd;
        const Vectors<V> p = cross(direction, e2), s = origin - a, q = cross(s, e1);
        const V signed_det = dot(e1, p);
        const V sign = hn::And(signed_det, all(-0.0f));
        det = hn::Xor(signed_det, sign);
        u = hn::Xor(dot(s, p), sign);
        v = hn::Xor(dot(direction, q), sign);
        t = hn::Xor(dot(e2, q), sign);
    }
    auto inside() const {
        using namespace simd;
        return hn::And(hn::And(hn::Ge(u, all(0)), hn::Ge(v, all(0))), hn::Le(hn::Add(u, v), det));
    }
    /// `scale`: |e1| |e2| |d| in taxicab lengths.
    auto trusted(V scale) const {
        using namespace simd;
        return hn::And(
            hn::Gt(det, hn::Mul(all(float_parallel), scale)),
            hn::And(hn::Gt(det, all(smallest_determinant)), hn::Lt(det, all(largest_determinant))));
    }

private:
    static V all(float x) { return simd::hn::Set(simd::hn::DFromV<V>(), x); }
};

/// padded(bounds(triangle), padding) of primitive/padding.h in every lane, plane by plane.
template <class V>
inline std::array<V, 6> padded_planes(const simd::Vectors<V>& a, const simd::Vectors<V>& b,
                                      const simd::Vectors<V>& c, float padding) {
    using namespace simd;
    constexpr hn::DFromV<V> tag;
    const auto lo = [](V x, V y, V z) { return smaller(z, smaller(y, x)); };
    const auto hi = [](V x, V y, V z) { return larger(z, larger(y, x)); };
    std::array<V, 6> planes{lo(a.x, b.x, c.x), lo(a.y, b.y, c.y), lo(a.z, b.z, c.z),
                            hi(a.x, b.x, c.x), hi(a.y, b.y, c.y), hi(a.z, b.z, c.z)};
    V largest = hn::Abs(planes[0]);
    for (std::size_t i = 1; i < 6; ++i) largest = hn::Max(largest, hn::Abs(planes[i]));
    const V radius = hn::MulAdd(hn::Set(tag, own_padding), largest, hn::Set(tag, padding));
    for (std::size_t i = 0; i < 3; ++i) {
        planes[i] = below(hn::Sub(planes[i], radius));
        planes[i + 3] = hn::Neg(below(hn::Neg(hn::Add(planes[i + 3], radius))));
    }
    return planes;
}

/// Triangles of a block that a ray's line meets, as the definition of a hit wants them (rules 1 and
/// 2 of core/README.md): t is clamped to the stored bounds.
struct BlockAnswer {
    std::uint32_t met;        ///< lanes whose triangle is met
    std::uint32_t untrusted;  ///< lanes that double has to decide
    TriangleBlock::Row t, u, v;
};

inline BlockAnswer intersect(const TriangleBlock& block, const TestRay& ray, float padding) {
    using namespace simd;
    constexpr auto tag = floats<TriangleBlock::width>;
    using V = Floats<TriangleBlock::width>;
    const auto corner = [&](std::size_t i) {
        return Vectors<V>{hn::Load(tag, block.corner[i].data()),
                          hn::Load(tag, block.corner[i + 1].data()),
                          hn::Load(tag, block.corner[i + 2].data())};
    };
    const Vectors<V> a = corner(0), b = corner(3), c = corner(6), e1 = b - a, e2 = c - a;
    const WideSums<V> sums(a, e1, e2, everywhere<TriangleBlock::width>(ray.origin),
                           everywhere<TriangleBlock::width>(ray.direction));
    const V sizes = hn::Mul(taxicab(e1), taxicab(e2));
    const auto trusted = sums.trusted(hn::Mul(sizes, hn::Set(tag, ray.direction_size)));
    const auto number = hn::Load(words<TriangleBlock::width>, block.primitive.data());
    const auto live =
        hn::RebindMask(tag, hn::Ne(number, hn::Set(words<TriangleBlock::width>, no_primitive)));
    const auto inside = hn::And(trusted, sums.inside());
    BlockAnswer answer;
    answer.met = bits(tag, inside);
    answer.untrusted = bits(tag, hn::AndNot(trusted, live));
    if (answer.met == 0) return answer;
    const std::array<V, 6> planes = padded_planes(a, b, c, padding);
    V entry = hn::Set(tag, -infinity), exit = hn::Set(tag, infinity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const V origin = hn::Set(tag, ray.origin[static_cast<int>(axis)]);
        const V inverse = hn::Set(tag, ray.inverse[static_cast<int>(axis)]);
        entry = larger(hn::Mul(hn::Sub(planes[ray.near[axis]], origin), inverse), entry);
        exit = smaller(hn::Mul(hn::Sub(planes[ray.far[axis]], origin), inverse), exit);
    }
    const V t = hn::Div(sums.t, sums.det);
    answer.met = bits(tag, hn::And(inside, hn::And(hn::Le(entry, exit), hn::Eq(t, t))));
    hn::StoreU(clamp(t, entry, exit), tag, answer.t.data());
    hn::StoreU(hn::Div(sums.u, sums.det), tag, answer.u.data());
    hn::StoreU(hn::Div(sums.v, sums.det), tag, answer.v.data());
    return answer;
}

/// What the float test cannot decide.
template <Counter C>
[[gnu::noinline]] void test_in_double(const TriangleBlock& block, std::size_t lane,
                                      const TestRay& ray, float padding, Hit& hit, C& count) {
    const Triangle triangle = block.triangle(lane);
    intersect_in_double(triangle, ray, [&](float t, float u, float v) {
        const bool met =
            offer(t, u, v, block.primitive[lane], padded(bounds(triangle), padding), ray, hit);
        if constexpr (C::counts) count(Event::object_hit, met);
    });
}

/// Tests every triangle of the block, as Leaves::test would one after the other.
template <Counter C>
inline void test(const TriangleBlock& block, const TestRay& ray, float padding, Hit& hit,
                 C& count) {
    const BlockAnswer answer = intersect(block, ray, padding);
    if constexpr (C::counts) {
        count(Event::object_test, block.live());
        count(Event::object_hit, static_cast<std::uint64_t>(std::popcount(answer.met)));
    }
    for (std::uint32_t rest = answer.met; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        accept({answer.t[lane], block.primitive[lane], answer.u[lane], answer.v[lane]}, ray.t_min,
               hit);
    }
    for (std::uint32_t rest = answer.untrusted; rest != 0; rest &= rest - 1) [[unlikely]]
        test_in_double(block, static_cast<std::size_t>(std::countr_zero(rest)), ray, padding, hit,
                       count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
