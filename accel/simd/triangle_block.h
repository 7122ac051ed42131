#pragma once

#include "accel/core/leaves.h"
#include "accel/simd/wide_box.h"

#include <bit>

/// Triangles side by side, tested against one ray at once by the arithmetic of
/// core/primitive/triangle.h, product-sum by product-sum, so that the answers are the same bits.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Lanes of a block that hold a primitive.
template <std::size_t Width>
inline std::size_t live_count(const std::array<std::uint32_t, Width>& primitive) {
    std::size_t count = 0;
    for (const std::uint32_t number : primitive) count += number != no_primitive;
    return count;
}
template <std::size_t Width>
inline auto live_lanes(simd::hn::FixedTag<float, Width> tag,
                       const std::array<std::uint32_t, Width>& primitive) {
    using namespace simd;
    const auto numbers = hn::LoadU(words<Width>, primitive.data());
    return hn::RebindMask(tag, hn::Ne(numbers, hn::Set(words<Width>, no_primitive)));
}

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
    std::size_t live() const { return live_count(primitive); }
    /// Of every triangle the same corner: 0, 1 or 2.
    simd::Vectors<simd::Floats<width>> corners(std::size_t which) const {
        const Row* row = &corner[3 * which];
        return {simd::hn::Load(simd::floats<width>, row[0].data()),
                simd::hn::Load(simd::floats<width>, row[1].data()),
                simd::hn::Load(simd::floats<width>, row[2].data())};
    }
};

/// TriangleSums and the float test's conditions in every lane.
template <class V>
class WideSums {
public:
    V det, u, v, t;

    /// `direction_size`: in taxicab lengths.
    WideSums(const simd::Vectors<V>& a, const simd::Vectors<V>& e1, const simd::Vectors<V>& e2,
             const simd::Vectors<V>& origin, const simd::Vectors<V>& direction, V direction_size) {
        using namespace simd;
        const Vectors<V> p = cross(direction, e2), s = origin - a, q = cross(s, e1);
        const V signed_det = dot(e1, p);
        const V sign = hn::And(signed_det, all(-0.0f));
        det = hn::Xor(signed_det, sign);
        u = hn::Xor(dot(s, p), sign);
        v = hn::Xor(dot(direction, q), sign);
        t = hn::Xor(dot(e2, q), sign);
        const V size1 = taxicab(e1), size2 = taxicab(e2), edges = hn::Add(size1, size2);
        scale_ = hn::Mul(hn::Mul(size1, size2), direction_size);
        largest_ = hn::Mul(direction_size, hn::Mul(edges, hn::Add(taxicab(s), edges)));
    }
    auto inside() const {
        using namespace simd;
        return hn::And(hn::And(hn::Ge(u, all(0)), hn::Ge(v, all(0))), hn::Le(hn::Add(u, v), det));
    }
    auto outside() const {
        using namespace simd;
        const V error = hn::Mul(all(sum_error), largest_), below = hn::Neg(error);
        return hn::And(in_range(largest_), hn::Or(hn::Lt(hn::Min(u, v), below),
                                                  hn::Gt(hn::Add(u, v), hn::Add(det, error))));
    }
    auto trusted() const {
        return simd::hn::And(simd::hn::Gt(det, simd::hn::Mul(all(float_parallel), scale_)),
                             in_range(det));
    }

private:
    static V all(float x) { return simd::hn::Set(simd::hn::DFromV<V>(), x); }
    static auto in_range(V x) {
        using namespace simd;
        return hn::And(hn::Gt(x, all(smallest_determinant)), hn::Lt(x, all(largest_determinant)));
    }

    V scale_;    ///< |e1| |e2| |d|
    V largest_;  ///< largest_sum()
};

/// strays() of core/primitive/triangle.h in every lane.
template <class V>
struct StraysFromTriangle {
    simd::Vectors<V> corner, origin, direction;

    auto operator()(V t, V clamped) const {
        using namespace simd;
        constexpr hn::DFromV<V> tag;
        const Vectors<V> apart = origin - corner, way = scaled(t, direction),
                         moved = scaled(hn::Sub(clamped, t), direction);
        return hn::Gt(dot(moved, moved), hn::Mul(hn::Set(tag, triangle_doubt),
                                                 hn::Add(dot(apart, apart), dot(way, way))));
    }
};

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
    const Vectors<V> a = block.corners(0), b = block.corners(1), c = block.corners(2);
    const Vectors<V> e1 = b - a, e2 = c - a;
    const Vectors<V> origin = everywhere<TriangleBlock::width>(ray.origin),
                     direction = everywhere<TriangleBlock::width>(ray.direction);
    const WideSums<V> sums(a, e1, e2, origin, direction, hn::Set(tag, ray.direction_size));
    const auto near = hn::AndNot(sums.outside(), live_lanes(tag, block.primitive));
    BlockAnswer answer;
    answer.met = answer.untrusted = 0;
    if (hn::AllFalse(tag, near)) return answer;
    const auto trusted = sums.trusted();
    const auto inside = hn::And(hn::And(near, trusted), sums.inside());
    answer.untrusted = bits(tag, hn::AndNot(trusted, near));
    const auto hit = clamped<V>({hn::Div(sums.t, sums.det), inside}, a, triangle_bounds(a, b, c),
                                origin, everywhere<TriangleBlock::width>(ray.inverse), padding,
                                StraysFromTriangle<V>{a, origin, direction});
    answer.met = bits(tag, hit.met);
    hn::StoreU(hit.t, tag, answer.t.data());
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
            offer(t, u, v, block.primitive[lane], padded(bounds(triangle), padding), ray, hit,
                  [&](float clamped) { return strays(triangle, ray, t, clamped); });
        if constexpr (C::counts) count(Event::object_hit, met);
    });
}

/// Rules 3 and 4 of core/README.md for the lanes that are met.
template <Counter C>
inline void accept_lanes(const TriangleBlock& block, const BlockAnswer& answer, float t_min,
                         Hit& hit, C& count) {
    if constexpr (C::counts) {
        count(Event::object_test, block.live());
        count(Event::object_hit, static_cast<std::uint64_t>(std::popcount(answer.met)));
    }
    for (std::uint32_t rest = answer.met; rest != 0; rest &= rest - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(rest));
        accept({answer.t[lane], block.primitive[lane], answer.u[lane], answer.v[lane]}, t_min, hit);
    }
}

/// Tests every triangle of the block, as Leaves::test would one after the other.
template <Counter C>
inline void test(const TriangleBlock& block, const TestRay& ray, float padding, Hit& hit,
                 C& count) {
    const BlockAnswer answer = intersect(block, ray, padding);
    accept_lanes(block, answer, ray.t_min, hit, count);
    for (std::uint32_t rest = answer.untrusted; rest != 0; rest &= rest - 1)
        [[unlikely]] test_in_double(block, static_cast<std::size_t>(std::countr_zero(rest)), ray,
                                    padding, hit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
