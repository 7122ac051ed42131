#pragma once

#include "accel/simd/triangle_block.h"

/// Precision::watertight side by side: intersect_watertight of core/primitive/triangle.h (Woop,
/// Benthin & Wald 2013), product by product, so that the answers are the same bits.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where lines meet triangles; t is NaN where they do not.
template <class V>
struct WideCrossing {
    V t, u, v;
};

/// EdgeFunctions of sheared triangles, in float and, for those that float does not rule out, in
/// double.
template <class V>
class WideEdges {
public:
    /// Corners as seen from the ray's origin, their components turned so that the ray's dominant
    /// axis is z.
    WideEdges(const simd::Vectors<V>& a, const simd::Vectors<V>& b, const simd::Vectors<V>& c,
              V along_x, V along_y)
        : a_(sheared(a, along_x, along_y)),
          b_(sheared(b, along_x, along_y)),
          c_(sheared(c, along_x, along_y)) {}

    /// Float is to be trusted, and its signs differ.
    auto outside() const {
        using namespace simd;
        const auto [a, b, c] = edges(a_, b_, c_);
        const V size_a = hn::Abs(a), size_b = hn::Abs(b), size_c = hn::Abs(c);
        const auto trusted =
            hn::And(hn::Gt(hn::Min(hn::Min(size_a, size_b), size_c), all(a, smallest_determinant)),
                    hn::Lt(hn::Add(hn::Add(size_a, size_b), size_c), all(a, infinity)));
        // None of them is zero here, so that their signs say all.
        const auto differ = hn::Or(hn::Xor(a, b), hn::Xor(a, c));
        return hn::And(trusted, is_negative(differ));
    }
    /// The products of two floats are exact in double.
    WideCrossing<V> exact(V direction_z) const {
        using namespace simd;
        if constexpr (double_parts<V> == 1) {
            return exact_part<0>(direction_z);
        } else {
            constexpr hn::DFromV<V> tag;
            const auto lower = exact_part<0>(direction_z), upper = exact_part<1>(direction_z);
            return {hn::Combine(tag, upper.t, lower.t), hn::Combine(tag, upper.u, lower.u),
                    hn::Combine(tag, upper.v, lower.v)};
        }
    }

private:
    static simd::Vectors<V> sheared(const simd::Vectors<V>& p, V along_x, V along_y) {
        return {simd::hn::NegMulAdd(along_x, p.z, p.x), simd::hn::NegMulAdd(along_y, p.z, p.y),
                p.z};
    }
    template <class W>
    static W all(W, double x) {
        using T = simd::hn::TFromV<W>;
        return simd::hn::Set(simd::hn::DFromV<W>(), static_cast<T>(x));
    }
    /// Products are rounded one by one: see EdgeFunctions.
    template <class W>
    static simd::Vectors<W> edges(const simd::Vectors<W>& a, const simd::Vectors<W>& b,
                                  const simd::Vectors<W>& c) {
        using namespace simd;
        return {hn::Sub(hn::Mul(c.x, b.y), hn::Mul(c.y, b.x)),
                hn::Sub(hn::Mul(a.x, c.y), hn::Mul(a.y, c.x)),
                hn::Sub(hn::Mul(b.x, a.y), hn::Mul(b.y, a.x))};
    }
    template <std::size_t Part>
    static auto in_double(const simd::Vectors<V>& p) {
        using D = decltype(simd::as_doubles<Part>(p.x));
        return simd::Vectors<D>{simd::as_doubles<Part>(p.x), simd::as_doubles<Part>(p.y),
                                simd::as_doubles<Part>(p.z)};
    }
    template <std::size_t Part>
    auto exact_part(V direction_z) const {
        using namespace simd;
        const auto a = in_double<Part>(a_), b = in_double<Part>(b_), c = in_double<Part>(c_);
        const auto [ea, eb, ec] = edges(a, b, c);
        const auto none = all(ea, 0);
        const auto minus = hn::Or(hn::Or(hn::Lt(ea, none), hn::Lt(eb, none)), hn::Lt(ec, none));
        const auto plus = hn::Or(hn::Or(hn::Gt(ea, none), hn::Gt(eb, none)), hn::Gt(ec, none));
        // Zero only where all three edge functions are: then t is 0 / 0.
        const auto det = hn::Add(hn::Add(ea, eb), ec);
        const auto missed = hn::And(minus, plus);
        const auto depth = hn::MulAdd(ea, a.z, hn::MulAdd(eb, b.z, hn::Mul(ec, c.z)));
        const auto t = hn::Div(depth, hn::Mul(det, as_doubles<Part>(direction_z)));
        const hn::Rebind<float, hn::DFromV<decltype(t)>> tag;
        const auto narrow = [&](auto x) { return hn::DemoteTo(tag, x); };
        using Floats = decltype(narrow(t));
        return WideCrossing<Floats>{narrow(hn::IfThenElse(missed, all(t, not_a_number), t)),
                                    narrow(hn::Div(eb, det)), narrow(hn::Div(ec, det))};
    }
    static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

    simd::Vectors<V> a_, b_, c_;  ///< sheared; z is left as it was
};

/// Shear of core/primitive/test_ray.h for a ray a lane, whose dominant axes may differ.
template <class V>
class WideShear {
public:
    V along_x, along_y, direction_z;

    explicit WideShear(const simd::Vectors<V>& d)
        : WideShear(d, simd::hn::Abs(d.x), simd::hn::Abs(d.y), simd::hn::Abs(d.z)) {}

    /// Components in the order that makes each ray's dominant axis z.
    simd::Vectors<V> turned(const simd::Vectors<V>& p) const {
        const auto pick = [&](V x, V y, V z) {
            return simd::hn::IfThenElse(z_, z, simd::hn::IfThenElse(y_, y, x));
        };
        return {pick(p.y, p.z, p.x), pick(p.z, p.x, p.y), pick(p.x, p.y, p.z)};
    }

private:
    using Mask = decltype(simd::hn::Ge(V{}, V{}));
    WideShear(const simd::Vectors<V>& d, V x, V y, V z)
        : z_(simd::hn::And(simd::hn::Ge(z, x), simd::hn::Ge(z, y))), y_(simd::hn::Ge(y, x)) {
        const simd::Vectors<V> p = turned(d);
        along_x = simd::hn::Div(p.x, p.z);
        along_y = simd::hn::Div(p.y, p.z);
        direction_z = p.z;
    }
    Mask z_, y_;
};

/// As intersect(block, ray, padding); no lane is left for double to decide.
inline BlockAnswer intersect_watertight(const TriangleBlock& block, const TestRay& ray,
                                        float padding) {
    using namespace simd;
    constexpr std::size_t width = TriangleBlock::width;
    constexpr auto tag = floats<width>;
    using V = Floats<width>;
    const Shear& shear = ray.shear;
    const float* const origin = &ray.origin.x;  // y and z follow it
    // Turned by taking the rows in another order.
    const auto seen = [&](std::size_t corner) {
        const auto row = [&](int axis) {
            const auto place = static_cast<std::size_t>(axis);
            return hn::Sub(hn::Load(tag, block.corner[3 * corner + place].data()),
                           hn::Set(tag, origin[place]));
        };
        return Vectors<V>{row(shear.x), row(shear.y), row(shear.z)};
    };
    const WideEdges<V> edges(seen(0), seen(1), seen(2), hn::Set(tag, shear.along_x),
                             hn::Set(tag, shear.along_y));
    const auto left = hn::AndNot(edges.outside(), live_lanes(tag, block.primitive));
    BlockAnswer answer;
    answer.untrusted = 0;
    answer.met = bits(tag, left);
    if (answer.met == 0) return answer;
    const WideCrossing<V> at = edges.exact(hn::Set(tag, ray.direction[shear.z]));
    const Vectors<V> a = block.corners(0), b = block.corners(1), c = block.corners(2);
    const auto hit = clamped<V>({at.t, hn::And(left, hn::Eq(at.t, at.t))}, a,
                                triangle_bounds(a, b, c), everywhere<width>(ray.origin),
                                everywhere<width>(ray.inverse), padding, NeverStrays());
    answer.met = bits(tag, hit.met);
    hn::StoreU(hit.t, tag, answer.t.data());
    hn::StoreU(at.u, tag, answer.u.data());
    hn::StoreU(at.v, tag, answer.v.data());
    return answer;
}

/// test(block, ...) in Precision::watertight.
template <Counter C>
inline void test_watertight(const TriangleBlock& block, const TestRay& ray, float padding, Hit& hit,
                            C& count) {
    accept_lanes(block, intersect_watertight(block, ray, padding), ray.t_min, hit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
