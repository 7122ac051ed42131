#pragma once

#include "accel/core/primitive/test_ray.h"

#include <algorithm>

/// The triangle and its two tests. Both are two-sided and report the line's hit at any t; the
/// shared place in leaves.h clamps and compares it.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Triangle {
    vec3 a, b, c;
};

inline Box bounds(const Triangle& triangle) {
    Box box;
    box.include(triangle.a);
    box.include(triangle.b);
    box.include(triangle.c);
    return box;
}

/// Below this share of |e1| |e2| |d| (taxicab lengths) a float determinant is not trusted, and what
/// may be a hit is decided in double; below the second a double one is not either: the ray is
/// parallel.
inline constexpr float float_parallel = 0x1p-7f;
inline constexpr double double_parallel = 0x1p-36;
/// Outside this range products of the float test may under- or overflow.
inline constexpr float smallest_determinant = 0x1p-80f, largest_determinant = 0x1p80f;
/// No sum of the float test is off by this share of the largest that it could be.
inline constexpr float sum_error = 0x1p-20f;
/// How far along the line a hit may be off: the square of its share of the distances to the
/// triangle and to the hit, 2 (9 * 2^-17)^2.
inline constexpr float triangle_doubt = 162 * 0x1p-34f;

/// Moeller & Trumbore 1997, but without a division before the ray is known to hit.
template <std::floating_point F>
struct TriangleSums {
    F det, u, v, t;  ///< u, v and t are still multiplied by det; the sign of det is taken out

    TriangleSums(const vec<F>& a, const vec<F>& e1, const vec<F>& e2, const vec<F>& origin,
                 const vec<F>& direction) {
        const vec<F> p = cross(direction, e2);
        const vec<F> s = origin - a;
        const vec<F> q = cross(s, e1);
        const F signed_det = dot(e1, p);
        const F sign = std::copysign(F(1), signed_det);
        det = signed_det * sign;
        u = dot(s, p) * sign;
        v = dot(direction, q) * sign;
        t = dot(e2, q) * sign;
    }
    /// False for NaN. One branch for its caller, not three that each go wrong now and then.
    bool inside() const { return (u >= 0) & (v >= 0) & (u + v <= det); }
    /// Whether the line passes the triangle, whatever the rounding. `largest`: largest_sum().
    bool outside(F largest) const {
        const F error = sum_error * largest;
        return (largest > smallest_determinant) & (largest < largest_determinant) &
               ((u < -error) | (v < -error) | (u + v > det + error));
    }
};

/// What |u|, |v| and |det| cannot exceed, from taxicab lengths: of e1 and e2 together, of s, of d.
template <class F>
F largest_sum(F edges, F apart, F direction) {
    return direction * (edges * (apart + edges));
}

template <class Accept>
[[gnu::noinline]] void intersect_in_double(const Triangle& triangle, const TestRay& ray,
                                           Accept&& accept) {
    const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
    const dvec3 direction(ray.direction);
    const TriangleSums<double> sums(a, e1, e2, dvec3(ray.origin), direction);
    const double scale = taxicab(e1) * taxicab(e2) * taxicab(direction);
    if (!(sums.det > double_parallel * scale) || !sums.inside()) return;
    accept(static_cast<float>(sums.t / sums.det), static_cast<float>(sums.u / sums.det),
           static_cast<float>(sums.v / sums.det));
}

/// Precision::standard. Calls accept(t, u, v) when the ray's line meets the triangle.
template <class Accept>
inline void intersect(const Triangle& triangle, const TestRay& ray, Accept&& accept) {
    const vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
    const TriangleSums<float> sums(triangle.a, e1, e2, ray.origin, ray.direction);
    const float size1 = taxicab(e1), size2 = taxicab(e2), apart = taxicab(ray.origin - triangle.a);
    if (sums.outside(largest_sum(size1 + size2, apart, ray.direction_size))) return;
    const float scale = size1 * size2 * ray.direction_size;
    const bool trusted = (sums.det > float_parallel * scale) & (sums.det > smallest_determinant) &
                         (sums.det < largest_determinant);
    if (!trusted) [[unlikely]]
        return intersect_in_double(triangle, ray, accept);
    if (!sums.inside()) return;
    accept(sums.t / sums.det, sums.u / sums.det, sums.v / sums.det);
}

/// Whether a clamp takes a hit of Precision::standard farther along its line than the test can err:
/// then the line passes the triangle (README, rule 2).
inline bool strays(const Triangle& triangle, const TestRay& ray, float t, float clamped) {
    const vec3 apart = ray.origin - triangle.a, way = t * ray.direction;
    const vec3 moved = (clamped - t) * ray.direction;
    return dot(moved, moved) > triangle_doubt * (dot(apart, apart) + dot(way, way));
}

/// Edge functions of the sheared triangle: positive multiples of the barycentrics, or all negative.
template <std::floating_point F>
struct EdgeFunctions {
    F a, b, c;
    /// Products are rounded one by one: so reversing an edge flips the sign exactly, and two
    /// triangles that share it agree on which side the ray passes.
    EdgeFunctions(F ax, F ay, F bx, F by, F cx, F cy)
        : a(cx * by - cy * bx), b(ax * cy - ay * cx), c(bx * ay - by * ax) {}
    bool outside() const { return (a < 0 || b < 0 || c < 0) && (a > 0 || b > 0 || c > 0); }
    F smallest() const { return std::min({std::abs(a), std::abs(b), std::abs(c)}); }
};

/// Precision::watertight (Woop, Benthin & Wald 2013), but t is always computed in double.
template <class Accept>
inline void intersect_watertight(const Triangle& triangle, const TestRay& ray, Accept&& accept) {
    const auto [x, y, z, along_x, along_y] = ray.shear;
    const vec3 a = triangle.a - ray.origin, b = triangle.b - ray.origin,
               c = triangle.c - ray.origin;
    const float ax = std::fma(-along_x, a[z], a[x]), ay = std::fma(-along_y, a[z], a[y]);
    const float bx = std::fma(-along_x, b[z], b[x]), by = std::fma(-along_y, b[z], b[y]);
    const float cx = std::fma(-along_x, c[z], c[x]), cy = std::fma(-along_y, c[z], c[y]);
    const EdgeFunctions<float> edges(ax, ay, bx, by, cx, cy);
    const bool trusted = edges.smallest() > smallest_determinant &&
                         std::abs(edges.a) + std::abs(edges.b) + std::abs(edges.c) < infinity;
    if (trusted && edges.outside()) return;
    // The products of two floats are exact in double, so a zero or a lost sign is set right here.
    const EdgeFunctions<double> exact(ax, ay, bx, by, cx, cy);
    const double det = exact.a + exact.b + exact.c;
    if (exact.outside() || det == 0) return;
    const double depth = std::fma(exact.a, a[z], std::fma(exact.b, b[z], exact.c * c[z]));
    accept(static_cast<float>(depth / (det * ray.direction[z])), static_cast<float>(exact.b / det),
           static_cast<float>(exact.c / det));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
