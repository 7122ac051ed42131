#include "accel/core/primitive/polygon.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "accel/core/primitive/clipping.h"
#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

dvec3 average(std::span<const vec3> corners) {
    dvec3 sum(0);
    for (const vec3& corner : corners) sum += dvec3(corner);
    return sum / static_cast<double>(corners.size());
}

/// Newell's normal, twice the area long; zero when it is no longer than its own rounding error.
dvec3 newell_normal(std::span<const vec3> corners, const dvec3& centre) {
    dvec3 sum(0);
    double size = 0;
    dvec3 here = dvec3(corners.back()) - centre;
    for (const vec3& corner : corners) {
        const dvec3 next = dvec3(corner) - centre;
        sum += cross(here, next);
        size += taxicab(here) * taxicab(next);
        here = next;
    }
    const double rounding = static_cast<double>(corners.size() + 8) * 0x1p-53;
    return taxicab(sum) > rounding * size ? sum : dvec3(0);
}

int dominant_axis(const dvec3& n) {
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    return z >= x && z >= y ? 2 : y >= x ? 1 : 0;
}

/// A point of the projection that drops `axis`.
struct Projected {
    double x, y;

    Projected(const dvec3& p, int axis) : x(p[(axis + 1) % 3]), y(p[(axis + 2) % 3]) {}
};

/// Even-odd rule. Half open: an edge owns its lower end but not its upper, and a point on an edge
/// is to the right of it; edges are taken from the lower end to the upper whichever polygon asks.
/// So where two polygons of one plane share an edge, each point is in exactly one of them.
bool inside(const Polygon& polygon, const dvec3& from_centre) {
    const Projected p(from_centre, polygon.axis);
    bool odd = false;
    Projected here(dvec3(polygon.corners.back()) - polygon.centre, polygon.axis);
    for (const vec3& corner : polygon.corners) {
        const Projected next(dvec3(corner) - polygon.centre, polygon.axis);
        if ((here.y > p.y) != (next.y > p.y)) {
            const Projected& low = here.y < next.y ? here : next;
            const Projected& high = here.y < next.y ? next : here;
            const double side = (high.x - low.x) * (p.y - low.y) - (high.y - low.y) * (p.x - low.x);
            odd ^= side > 0;
        }
        here = next;
    }
    return odd;
}

std::vector<dvec3> flattened_corners(const Polygon& polygon) {
    std::vector<dvec3> flat;
    flat.reserve(polygon.corners.size());
    for (const vec3& corner : polygon.corners) flat.push_back(flattened(polygon, corner));
    return flat;
}

}  // namespace

Polygon make_polygon(std::span<const vec3> corners, std::span<const vec3> normals) {
    if (corners.size() < 3)
        throw std::invalid_argument("a polygon needs at least 3 corners, but " +
                                    std::to_string(corners.size()) + " were given");
    if (!normals.empty() && normals.size() != corners.size())
        throw std::invalid_argument("a polygon needs one normal per corner or none, but has " +
                                    std::to_string(corners.size()) + " corners and " +
                                    std::to_string(normals.size()) + " normals");
    Polygon polygon;
    polygon.corners.assign(corners.begin(), corners.end());
    polygon.normals.assign(normals.begin(), normals.end());
    polygon.centre = average(corners);
    polygon.normal = newell_normal(corners, polygon.centre);
    polygon.axis = dominant_axis(polygon.normal);
    return polygon;
}

std::optional<float> crossing(const Polygon& polygon, const vec3& origin, const vec3& direction) {
    const dvec3 d(direction), from_centre = dvec3(origin) - polygon.centre;
    const double rate = dot(polygon.normal, d);
    if (!(std::abs(rate) > parallel_polygon * taxicab(polygon.normal) * taxicab(d))) return {};
    // First to the line's point nearest to the centre: a far origin is out of all that follows.
    const double to_centre = -dot(from_centre, d) / dot(d, d);
    const dvec3 near = along(from_centre, to_centre, d);
    const double to_plane = -dot(polygon.normal, near) / rate;
    if (!inside(polygon, along(near, to_plane, d))) return {};
    return static_cast<float>(to_centre + to_plane);
}

dvec3 flattened(const Polygon& polygon, const vec3& corner) {
    const int axis = polygon.axis, j = (axis + 1) % 3, k = (axis + 2) % 3;
    const dvec3 from_centre = dvec3(corner) - polygon.centre;
    dvec3 flat(corner);
    const dvec3& n = polygon.normal;
    if (n[axis] != 0)
        flat[axis] =
            polygon.centre[axis] - std::fma(n[j], from_centre[j], n[k] * from_centre[k]) / n[axis];
    return flat;
}

Box bounds(const Polygon& polygon) {
    Box box;
    for (const vec3& corner : polygon.corners) {
        const dvec3 flat = flattened(polygon, corner);
        for (int axis = 0; axis < 3; ++axis) {
            box.lo[axis] = std::min(box.lo[axis], rounded_down(flat[axis]));
            box.hi[axis] = std::max(box.hi[axis], rounded_up(flat[axis]));
        }
    }
    return box;
}

Box clipped_bounds(const Polygon& polygon, const Box& box) {
    return clipped_bounds(flattened_corners(polygon), box);
}

bool overlaps(const Polygon& polygon, const Box& box, float radius) {
    return !clipped_bounds(polygon, radius > 0 ? box.grown(radius) : box).empty();
}

float support(const Polygon& polygon, const vec3& direction) {
    const dvec3 d(direction);
    double farthest = -std::numeric_limits<double>::infinity();
    for (const vec3& corner : polygon.corners)
        farthest = std::max(farthest, dot(flattened(polygon, corner), d));
    const double size = double(largest_coordinate(bounds(polygon))) * taxicab(d);
    return rounded_up(std::fma(0x1p-48, size, farthest));
}

vec3 geometric_normal(const Polygon& polygon) {
    const double size = length(polygon.normal);
    return size > 0 ? vec3(polygon.normal / size) : vec3(0, 0, 1);
}

namespace {

/// A corner seen from the point in question, in the projection.
struct SeenCorner {
    Projected from_point;
    double distance;
    dvec3 normal;

    SeenCorner(const Polygon& polygon, std::size_t i, const vec3& point)
        : from_point(dvec3(polygon.corners[i]) - dvec3(point), polygon.axis),
          distance(std::sqrt(from_point.x * from_point.x + from_point.y * from_point.y)),
          normal(polygon.normals[i]) {}
};

vec3 unit_or(const dvec3& direction, const vec3& otherwise) {
    const double size = length(direction);
    return size > 0 && std::isfinite(size) ? vec3(direction / size) : otherwise;
}

}  // namespace

vec3 shading_normal(const Polygon& polygon, const vec3& point) {
    const vec3 flat = geometric_normal(polygon);
    if (polygon.normals.empty()) return flat;
    dvec3 sum(0);
    SeenCorner a(polygon, polygon.corners.size() - 1, point);
    for (std::size_t i = 0; i < polygon.corners.size(); ++i) {
        const SeenCorner b(polygon, i, point);
        const double twice_area = a.from_point.x * b.from_point.y - a.from_point.y * b.from_point.x;
        const double product = a.from_point.x * b.from_point.x + a.from_point.y * b.from_point.y;
        if (twice_area == 0 && product <= 0)  // on this edge, or at one of its ends
            return unit_or(b.distance * a.normal + a.distance * b.normal, flat);
        // Floater 2003: tan(angle / 2) over the corner's distance, here without an angle.
        if (twice_area != 0) {
            const double tangent = (a.distance * b.distance - product) / twice_area;
            sum += tangent / a.distance * a.normal + tangent / b.distance * b.normal;
        }
        a = b;
    }
    // Clockwise in the projection every share has the other sign.
    return unit_or(polygon.normal[polygon.axis] < 0 ? -sum : sum, flat);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
