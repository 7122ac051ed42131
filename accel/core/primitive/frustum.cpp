#include "accel/core/primitive/frustum.h"

#include <algorithm>

#include <glm/common.hpp>

#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// A frustum round its middle: radius(m) = radius + slope * m for m in [-half_length, half_length].
struct Axis {
    dvec3 middle, unit;
    double half_length, radius, slope;

    explicit Axis(const Frustum& f)
        : middle(0.5 * (dvec3(f.base) + dvec3(f.apex))),
          unit(dvec3(f.apex) - dvec3(f.base)),
          half_length(0.5 * length(unit)),
          radius(0.5 * (double(f.base_radius) + double(f.apex_radius))),
          slope(half_length > 0
                    ? 0.5 * (double(f.apex_radius) - double(f.base_radius)) / half_length
                    : 0) {
        unit = half_length > 0 ? unit / (2 * half_length) : dvec3(0);
    }
    /// The largest distance within it, up to a factor of 2.
    double size() const { return half_length + radius + std::abs(slope) * half_length; }
    bool degenerate() const { return !(half_length > 0 && radius > 0); }
    double radius_at(double m) const { return std::max(std::fma(slope, m, radius), 0.0); }
    /// Half the width of a unit circle round the axis, seen along a coordinate axis.
    dvec3 circle_extent() const {
        if (!(half_length > 0)) return dvec3(1);  // a point with a radius: bounded like a sphere
        return {std::sqrt(std::fma(unit.y, unit.y, unit.z * unit.z)),
                std::sqrt(std::fma(unit.z, unit.z, unit.x * unit.x)),
                std::sqrt(std::fma(unit.x, unit.x, unit.y * unit.y))};
    }
};

/// A line seen from the axis. `off_axis` and `turn` are position and direction crossed with the
/// axis, so |off_axis + t * turn| is the distance from the axis; the radius it is to be compared
/// with is reach + t * growth.
struct AxialLine {
    dvec3 off_axis, turn;
    double height, climb;
    double reach, growth;

    AxialLine(const Axis& axis, const dvec3& position, const dvec3& direction)
        : off_axis(cross(position, axis.unit)),
          turn(cross(direction, axis.unit)),
          height(dot(position, axis.unit)),
          climb(dot(direction, axis.unit)) {
        set_radii(axis);
    }
    /// Moves the line's zero by t.
    void advance(const Axis& axis, double t) {
        off_axis = along(off_axis, t, turn);
        height = std::fma(t, climb, height);
        set_radii(axis);
    }
    void set_radii(const Axis& axis) {
        reach = std::fma(axis.slope, height, axis.radius);
        growth = axis.slope * climb;
    }
};

/// Share of the frustum's size within which a root must lie at the surface. A root of an
/// ill-conditioned equation (a line along a generator) that does not is no crossing, so that the
/// distance of a reported point is bounded by construction.
constexpr double root_tolerance = 0x1p-25;
/// How far from it the point may be, likewise a share: up to four times the tolerance, as a flat
/// cone turns a difference of radii into one of heights.
constexpr double farthest_from_surface = 0x1p-23;

/// In the half plane of height and distance from the axis, where the surface is a line segment.
bool on_surface(const Axis& axis, const AxialLine& line, double t) {
    const double height = std::fma(t, line.climb, line.height);
    if (!(std::abs(height) <= axis.half_length)) return false;
    const double distance = length(along(line.off_axis, t, line.turn));
    const double radius = std::fma(t, line.growth, line.reach);
    const double steepness = std::abs(axis.slope);
    const double half_range = steepness * axis.half_length;
    const double tolerance = root_tolerance * axis.size();
    return std::abs(distance - radius) <= tolerance * (1 + steepness) &&
           std::abs(distance - axis.radius) <= half_range + tolerance;
}

/// The roots of |off_axis + t turn|^2 = (reach + t growth)^2. Its discriminant is the difference of
/// two squares (Lagrange's identity, with the radius as a time-like coordinate), which keeps it
/// accurate where b^2 - a c would cancel.
std::array<double, 2> roots(const Axis& axis, const AxialLine& line) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double a = dot(line.turn, line.turn) - line.growth * line.growth;
    const double b = dot(line.off_axis, line.turn) - line.reach * line.growth;
    const double c = dot(line.off_axis, line.off_axis) - line.reach * line.reach;
    const double cone = length(line.reach * line.turn - line.growth * line.off_axis);
    const double twist = std::abs(dot(cross(line.off_axis, line.turn), axis.unit));
    const double discriminant = (cone - twist) * (cone + twist);
    if (!(discriminant >= 0)) return {none, none};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    return {q / a, c / q};
}

}  // namespace

Crossings crossings(const Frustum& frustum, const vec3& origin, const vec3& direction) {
    Crossings found;
    const Axis axis(frustum);
    if (axis.degenerate()) return found;
    // Two shifts of the line's zero: near the middle, which takes a far origin out of all that
    // follows, then to the line's point nearest to the axis, which serves long thin frusta.
    const dvec3 d(direction), from_middle = dvec3(origin) - axis.middle;
    const double square = dot(d, d);
    const double to_middle = -dot(from_middle, d) / square;
    AxialLine line(axis, along(from_middle, to_middle, d), d);
    const double turn_square = dot(line.turn, line.turn);
    const double farthest = 2 * (axis.half_length + axis.radius) / std::sqrt(square);
    const double nearest = -dot(line.off_axis, line.turn) / turn_square;
    const double to_axis = turn_square > 0 ? std::clamp(nearest, -farthest, farthest) : 0;
    line.advance(axis, to_axis);
    for (const double root : roots(axis, line))
        if (on_surface(axis, line, root))
            found.t[static_cast<std::size_t>(found.count++)] =
                static_cast<float>(to_middle + (to_axis + root));
    return found;
}

vec3 normal_at(const Frustum& frustum, const vec3& point) {
    const Axis axis(frustum);
    const dvec3 p = dvec3(point) - axis.middle;
    const dvec3 radial = p - dot(p, axis.unit) * axis.unit;
    const double distance = length(radial);
    if (distance > 0) return vec3(normalised(radial / distance - axis.slope * axis.unit));
    if (axis.slope != 0) return vec3(axis.slope > 0 ? -axis.unit : axis.unit);
    // On the axis of a cylinder every direction across is as near.
    const bool flat = std::abs(axis.unit.x) < 0.5;
    return vec3(normalised(cross(flat ? dvec3(1, 0, 0) : dvec3(0, 1, 0), axis.unit)));
}

namespace {

/// Share of the largest coordinate that covers the rounding of everything below, generously.
constexpr double slack = 0x1p-44;

/// Heights m for which the circle may meet a box.
struct Heights {
    double from, to;

    bool empty() const { return !(from <= to); }
    /// Keeps what satisfies offset + rate * m <= 0.
    void keep(double offset, double rate) {
        if (rate > 0) to = std::min(to, -offset / rate);
        if (rate < 0) from = std::max(from, -offset / rate);
        if (rate == 0 && offset > 0) to = -std::numeric_limits<double>::infinity();
    }
};

Box circle_hull(const Axis& axis, const Heights& heights, double margin) {
    const dvec3 extent = axis.circle_extent();
    Box box;
    for (int i = 0; i < 3; ++i) {
        double lo = std::numeric_limits<double>::infinity(), hi = -lo;
        for (const double m : {heights.from, heights.to}) {
            const double centre = std::fma(m, axis.unit[i], axis.middle[i]);
            lo = std::min(lo, std::fma(-axis.radius_at(m), extent[i], centre));
            hi = std::max(hi, std::fma(axis.radius_at(m), extent[i], centre));
        }
        box.lo[i] = rounded_down(lo - margin);
        box.hi[i] = rounded_up(hi + margin);
    }
    return box;
}

/// Heights at which the circle's extent along every coordinate axis, and the axis itself, meet the
/// box; `margin` loosens each comparison.
Heights heights_in(const Axis& axis, const Box& box, double margin) {
    Heights heights{-axis.half_length, axis.half_length};
    const dvec3 extent = axis.circle_extent();
    for (int i = 0; i < 3; ++i) {
        const double reach = axis.radius * extent[i], growth = axis.slope * extent[i];
        heights.keep(axis.middle[i] - reach - box.hi[i] - margin, axis.unit[i] - growth);
        heights.keep(box.lo[i] - axis.middle[i] - reach - margin, -axis.unit[i] - growth);
    }
    const dvec3 centre = 0.5 * (dvec3(box.lo) + dvec3(box.hi)) - axis.middle;
    const dvec3 half = 0.5 * (dvec3(box.hi) - dvec3(box.lo));
    const double middle = dot(centre, axis.unit);
    const double spread = dot(half, glm::abs(axis.unit)) + margin;
    heights.keep(middle - spread, -1);
    heights.keep(-middle - spread, 1);
    return {std::max(heights.from - margin, -axis.half_length),
            std::min(heights.to + margin, axis.half_length)};
}

/// Whether the box lies between the axis and the surface, or wholly outside the cone.
bool beside_surface(const Axis& axis, const Box& box, double margin) {
    const dvec3 centre = 0.5 * (dvec3(box.lo) + dvec3(box.hi)) - axis.middle;
    const dvec3 half = 0.5 * (dvec3(box.hi) - dvec3(box.lo));
    bool inside = true;
    for (int corner = 0; corner < 8; ++corner) {
        dvec3 p = centre;
        for (int i = 0; i < 3; ++i) p[i] += (corner >> i & 1) ? half[i] : -half[i];
        const double radius = std::fma(axis.slope, dot(p, axis.unit), axis.radius);
        inside =
            inside && length(cross(p, axis.unit)) + margin * (1 + std::abs(axis.slope)) < radius;
    }
    if (inside) return true;
    // The tangent plane of the cone towards the box's centre: no point of the surface is beyond it.
    const dvec3 radial = centre - dot(centre, axis.unit) * axis.unit;
    const double distance = length(radial);
    if (!(distance > 0)) return false;
    const dvec3 normal = radial / distance - axis.slope * axis.unit;
    const double nearest = dot(centre, normal) - dot(half, glm::abs(normal));
    return nearest > axis.radius + margin * (1 + std::abs(axis.slope));
}

double margin_of(const Box& whole) { return slack * double(largest_coordinate(whole)); }

}  // namespace

Box bounds(const Frustum& frustum) {
    const Axis axis(frustum);
    const double margin = farthest_from_surface * axis.size();
    Box box;
    for (const auto& [centre, radius] :
         {std::pair(dvec3(frustum.base), double(frustum.base_radius)),
          std::pair(dvec3(frustum.apex), double(frustum.apex_radius))}) {
        const dvec3 reach = radius * (axis.circle_extent() * (1 + 0x1p-48));
        Box circle;
        for (int i = 0; i < 3; ++i) {
            circle.lo[i] = rounded_down(centre[i] - reach[i] - margin);
            circle.hi[i] = rounded_up(centre[i] + reach[i] + margin);
        }
        box.include(circle);
    }
    return box;
}

Box clipped_bounds(const Frustum& frustum, const Box& box) {
    const Axis axis(frustum);
    const Box whole = bounds(frustum);
    const double margin = margin_of(whole);
    Box part = whole.intersection(box);
    constexpr int rounds = 3;  // each shrinks the box that the next one clips against
    for (int round = 0; round < rounds && !part.empty(); ++round) {
        const Heights heights = heights_in(axis, part, margin);
        if (heights.empty()) return {};
        part = part.intersection(circle_hull(axis, heights, margin));
    }
    return part.empty() ? Box{} : part;
}

bool overlaps(const Frustum& frustum, const Box& box, float radius) {
    const Box whole = bounds(frustum);
    const Box near = (radius > 0 ? box.grown(radius) : box).intersection(whole);
    if (near.empty()) return false;
    return !clipped_bounds(frustum, near).empty() &&
           !beside_surface(Axis(frustum), near, margin_of(whole));
}

float support(const Frustum& frustum, const vec3& direction) {
    const Axis axis(frustum);
    const dvec3 d(direction);
    const double across = axis.half_length > 0 ? length(cross(d, axis.unit)) : length(d);
    const double farthest =
        std::max(std::fma(double(frustum.base_radius), across, dot(dvec3(frustum.base), d)),
                 std::fma(double(frustum.apex_radius), across, dot(dvec3(frustum.apex), d)));
    const double size = double(largest_coordinate(bounds(frustum))) * taxicab(d);
    return rounded_up(std::fma(0x1p-48, size, farthest));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
