#pragma once

#include "accel/core/neighbour.h"
#include "accel/core/ray.h"

#include <array>

/// Axis-aligned boxes and the one slab form that every structure uses.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Box {
    vec3 lo{infinity};
    vec3 hi{-infinity};

    bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
    vec3 size() const { return hi - lo; }
    vec3 centre() const { return 0.5f * lo + 0.5f * hi; }
    float half_area() const {
        const vec3 s = size();
        return std::fma(s.x, s.y, std::fma(s.y, s.z, s.z * s.x));
    }

    void include(const vec3& p) {
        for (int axis = 0; axis < 3; ++axis) {
            lo[axis] = p[axis] < lo[axis] ? p[axis] : lo[axis];
            hi[axis] = p[axis] > hi[axis] ? p[axis] : hi[axis];
        }
    }
    void include(const Box& b) {
        for (int axis = 0; axis < 3; ++axis) {
            lo[axis] = b.lo[axis] < lo[axis] ? b.lo[axis] : lo[axis];
            hi[axis] = b.hi[axis] > hi[axis] ? b.hi[axis] : hi[axis];
        }
    }
    bool contains(const vec3& p) const {
        return lo.x <= p.x && p.x <= hi.x && lo.y <= p.y && p.y <= hi.y && lo.z <= p.z &&
               p.z <= hi.z;
    }
    bool contains(const Box& b) const { return contains(b.lo) && contains(b.hi); }
    /// Touching counts: boxes are closed.
    bool overlaps(const Box& b) const {
        return lo.x <= b.hi.x && b.lo.x <= hi.x && lo.y <= b.hi.y && b.lo.y <= hi.y &&
               lo.z <= b.hi.z && b.lo.z <= hi.z;
    }
    /// Grown outward by `radius` >= 0 and rounded outward.
    Box grown(float radius) const {
        Box b;
        for (int axis = 0; axis < 3; ++axis) {
            b.lo[axis] = float_below(lo[axis] - radius);
            b.hi[axis] = float_above(hi[axis] + radius);
        }
        return b;
    }
    Box intersection(const Box& b) const {
        Box r;
        for (int axis = 0; axis < 3; ++axis) {
            r.lo[axis] = lo[axis] > b.lo[axis] ? lo[axis] : b.lo[axis];
            r.hi[axis] = hi[axis] < b.hi[axis] ? hi[axis] : b.hi[axis];
        }
        return r;
    }
    bool operator==(const Box&) const = default;
};

/// The part of a ray between two parallel planes; empty when entry > exit.
struct Interval {
    float entry = -infinity;
    float exit = infinity;

    bool empty() const { return !(entry <= exit); }
    float clamp(float t) const { return t < entry ? entry : t > exit ? exit : t; }
};

/// A ray with what every slab test needs of it.
struct SlabRay {
    vec3 origin;
    vec3 inverse;                     ///< 1 / direction; infinite where a component is zero
    std::array<bool, 3> descending;   ///< sign bit of the direction: the near plane is `hi`
    std::array<std::size_t, 3> near;  ///< place of each axis' near plane in {lo.xyz, hi.xyz}
    std::array<std::size_t, 3> far;   ///< ... and of the far one

    explicit SlabRay(const vec3& o, const vec3& d)
        : origin(o),
          inverse(1.0f / d.x, 1.0f / d.y, 1.0f / d.z),
          descending{std::signbit(d.x), std::signbit(d.y), std::signbit(d.z)} {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // Sums, not choices: signs cannot be foretold.
            const std::size_t high = std::size_t{3} * descending[axis];
            near[axis] = axis + high;
            far[axis] = axis + 3 - high;
        }
    }

    /// Parameter at which the ray meets a plane across `axis`; NaN when it runs inside that plane.
    float at(int axis, float plane) const { return (plane - origin[axis]) * inverse[axis]; }
};

/// The ray's interval inside a box. Rounding is monotone, so nested boxes give nested intervals,
/// exactly; a NaN (origin on a plane, zero component) bounds nothing and is passed over.
inline Interval clip(const SlabRay& ray, const Box& box, Interval within = {}) {
    for (int axis = 0; axis < 3; ++axis) {
        const float near = ray.at(axis, ray.descending[axis] ? box.hi[axis] : box.lo[axis]);
        const float far = ray.at(axis, ray.descending[axis] ? box.lo[axis] : box.hi[axis]);
        within.entry = near > within.entry ? near : within.entry;
        within.exit = far < within.exit ? far : within.exit;
    }
    return within;
}

/// Several boxes side by side, plane by plane (lo.x, lo.y, lo.z, hi.x, hi.y, hi.z): the layout of
/// nodes.
template <std::size_t Width>
struct alignas(Width * sizeof(float)) Boxes {
    static constexpr std::size_t width = Width;

    std::array<std::array<float, Width>, 6> planes;

    Boxes() {
        for (std::size_t i = 0; i < Width; ++i) set(i, Box{});
    }
    void set(std::size_t i, const Box& box) {
        for (int axis = 0; axis < 3; ++axis) {
            planes[static_cast<std::size_t>(axis)][i] = box.lo[axis];
            planes[static_cast<std::size_t>(axis) + 3][i] = box.hi[axis];
        }
    }
};

template <std::size_t Width>
struct Intervals {
    std::array<float, Width> entry, exit;

    bool met(std::size_t i) const { return entry[i] <= exit[i]; }
};

/// clip() of every box at once: the same form, so the same intervals.
template <std::size_t Width>
inline Intervals<Width> clip(const SlabRay& ray, const Boxes<Width>& boxes,
                             const Interval& within) {
    Intervals<Width> result;
    result.entry.fill(within.entry);
    result.exit.fill(within.exit);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float origin = ray.origin[static_cast<int>(axis)];
        const float inverse = ray.inverse[static_cast<int>(axis)];
        const auto& near_planes = boxes.planes[ray.near[axis]];
        const auto& far_planes = boxes.planes[ray.far[axis]];
        for (std::size_t i = 0; i < Width; ++i) {
            const float near = (near_planes[i] - origin) * inverse;
            const float far = (far_planes[i] - origin) * inverse;
            result.entry[i] = near > result.entry[i] ? near : result.entry[i];
            result.exit[i] = far < result.exit[i] ? far : result.exit[i];
        }
    }
    return result;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
