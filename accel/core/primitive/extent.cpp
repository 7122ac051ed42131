#include "accel/core/primitive/extent.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

#include "accel/core/primitive/clipping.h"
#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Share of the largest quantity that covers the rounding of these computations in double.
constexpr double slack = 0x1p-46;

std::array<dvec3, 3> corners(const Triangle& triangle) {
    return {dvec3(triangle.a), dvec3(triangle.b), dvec3(triangle.c)};
}

Box widened(const Box& box, float radius) { return radius > 0 ? box.grown(radius) : box; }

/// Separation of a triangle, given from the box's centre, and a box of half size along `axis`.
bool separated(const std::array<dvec3, 3>& p, const dvec3& half, const dvec3& axis) {
    const double a = dot(p[0], axis), b = dot(p[1], axis), c = dot(p[2], axis);
    const double reach = dot(half, glm::abs(axis));
    const double size =
        reach + std::max({taxicab(p[0]), taxicab(p[1]), taxicab(p[2])}) * taxicab(axis);
    const double gap = std::max(std::min({a, b, c}), -std::max({a, b, c})) - reach;
    return gap > slack * size;
}

/// The smallest and largest |x - centre| over an interval.
struct Distances {
    double least, most;

    Distances(double lo, double hi, double centre)
        : least(std::max({lo - centre, centre - hi, 0.0})),
          most(std::max(std::abs(lo - centre), std::abs(hi - centre))) {}
};

}  // namespace

Box clipped_bounds(const Triangle& triangle, const Box& box) {
    const auto shape = corners(triangle);
    return clipped_bounds(std::span<const dvec3>(shape), box).intersection(bounds(triangle));
}

bool overlaps(const Triangle& triangle, const Box& box, float radius) {
    const Box near = widened(box, radius);
    if (!near.overlaps(bounds(triangle))) return false;
    // Only the part near the triangle matters: so an unbounded box does no harm.
    const Box part = near.intersection(bounds(triangle));
    const dvec3 centre = 0.5 * (dvec3(part.lo) + dvec3(part.hi));
    const dvec3 half = 0.5 * (dvec3(part.hi) - dvec3(part.lo));
    auto p = corners(triangle);
    for (dvec3& corner : p) corner -= centre;
    const std::array<dvec3, 3> edges{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
    if (separated(p, half, cross(edges[0], edges[1]))) return false;
    for (const dvec3& e : edges)
        for (const dvec3& axis : {dvec3(0, -e.z, e.y), dvec3(e.z, 0, -e.x), dvec3(-e.y, e.x, 0)})
            if (separated(p, half, axis)) return false;
    return true;
}

float support(const Triangle& triangle, const vec3& direction) {
    const dvec3 d(direction);
    double farthest = -std::numeric_limits<double>::infinity();
    for (const dvec3& p : corners(triangle)) farthest = std::max(farthest, dot(p, d));
    const double size = double(largest_coordinate(bounds(triangle))) * taxicab(d);
    return rounded_up(std::fma(0x1p-50, size, farthest));
}

Box clipped_bounds(const Sphere& sphere, const Box& box) {
    const dvec3 centre(sphere.centre);
    const double radius = sphere.radius, square = radius * radius;
    Box part = box.intersection(padded(bounds(sphere), 0));
    const double margin = slack * (double(largest_coordinate(part)) + taxicab(centre) + radius);
    for (int round = 0; round < 2; ++round) {  // one axis's result narrows the others
        for (int axis = 0; axis < 3; ++axis) {
            if (part.empty()) return {};
            const int j = (axis + 1) % 3, k = (axis + 2) % 3;
            const Distances dj(part.lo[j], part.hi[j], centre[j]);
            const Distances dk(part.lo[k], part.hi[k], centre[k]);
            const double outer = square - dj.least * dj.least - dk.least * dk.least;
            const double inner = square - dj.most * dj.most - dk.most * dk.most;
            // Of the terms above, each is known to 2^-51 of the largest: so is their sum's root.
            const double doubt = 0x1p-48 * (square + dj.most * dj.most + dk.most * dk.most);
            if (outer < -doubt) return {};
            const double far = std::sqrt(std::max(outer, 0.0) + doubt) + margin;
            const double near = inner > doubt ? std::sqrt(inner - doubt) - margin : 0;
            const double c = centre[axis];
            part.lo[axis] = std::max(part.lo[axis], rounded_down(c - far));
            part.hi[axis] = std::min(part.hi[axis], rounded_up(c + far));
            // Nothing of the surface is nearer to the centre's plane than `near`.
            if (part.lo[axis] > c - near)
                part.lo[axis] = std::max(part.lo[axis], rounded_down(c + near));
            if (part.hi[axis] < c + near)
                part.hi[axis] = std::min(part.hi[axis], rounded_up(c - near));
        }
    }
    return part.empty() ? Box{} : part;
}

bool overlaps(const Sphere& sphere, const Box& box, float radius) {
    if (box.empty()) return false;
    double least = 0, most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Distances d(box.lo[axis], box.hi[axis], sphere.centre[axis]);
        least += d.least * d.least;
        most += d.most * d.most;
    }
    const double outer = (double(sphere.radius) + radius) * (1 + slack);
    const double inner = (double(sphere.radius) - radius) * (1 - slack);
    return std::sqrt(least) <= outer && (inner <= 0 || std::sqrt(most) >= inner);
}

float support(const Sphere& sphere, const vec3& direction) {
    const dvec3 d(direction), centre(sphere.centre);
    const double farthest = std::fma(double(sphere.radius), length(d), dot(centre, d));
    const double size = (taxicab(centre) + sphere.radius) * taxicab(d);
    return rounded_up(std::fma(0x1p-49, size, farthest));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
