#include "tests/core/truth.h"

#include <algorithm>

namespace rayshoot::truth {
namespace {

Real distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a, from = p - a;
    const Real square = dot(along, along);
    Real share = square > 0 ? Real(dot(from, along) / square) : Real(0);
    share = std::clamp(share, Real(0), Real(1));
    return length(from - share * along);
}

/// The corners of the polygon that the primitive stands for, from its stored plane.
std::vector<Point> corners_in_plane(const Polygon& polygon) {
    std::vector<Point> corners;
    const Point centre(polygon.centre), normal(polygon.normal);
    for (const vec3& corner : polygon.corners) {
        const Point p(corner);
        const Real off = dot(normal, p - centre) / normal[polygon.axis];
        std::array<Real, 3> moved{p.x, p.y, p.z};
        moved[static_cast<std::size_t>(polygon.axis)] -= off;
        corners.emplace_back(moved[0], moved[1], moved[2]);
    }
    return corners;
}

bool inside(const std::vector<Point>& corners, const Point& p, int axis) {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    bool odd = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if ((a[k] > p[k]) == (b[k] > p[k])) continue;
        const Real crossing = a[j] + (p[k] - a[k]) / (b[k] - a[k]) * (b[j] - a[j]);
        if (p[j] < crossing) odd = !odd;
    }
    return odd;
}

}  // namespace

Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Point operator*(const Real& s, const Point& a) { return {s * a.x, s * a.y, s * a.z}; }
Real dot(const Point& a, const Point& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real length(const Point& a) { return sqrt(dot(a, a)); }

Point point_at(const Ray& ray, float t) {
    return Point(ray.origin) + Real(t) * Point(ray.direction);
}

Real distance(const Point& p, const Triangle& triangle) {
    const Point a(triangle.a), b(triangle.b), c(triangle.c);
    const Point normal = cross(b - a, c - a);
    const Real square = dot(normal, normal);
    if (square > 0 && dot(cross(b - a, p - a), normal) >= 0 &&
        dot(cross(c - b, p - b), normal) >= 0 && dot(cross(a - c, p - c), normal) >= 0)
        return abs(dot(normal, p - a)) / sqrt(square);
    return std::min(
        {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

Real distance(const Point& p, const Sphere& sphere) {
    return abs(length(p - Point(sphere.centre)) - Real(sphere.radius));
}

Real distance(const Point& p, const Frustum& frustum) {
    const Point base(frustum.base), axis = Point(frustum.apex) - base, from = p - base;
    const Real size = length(axis), height = dot(from, axis) / size;
    const Real off_axis = length(cross(from, axis)) / size;
    return distance_to_segment({height, off_axis, 0}, {0, Real(frustum.base_radius), 0},
                               {size, Real(frustum.apex_radius), 0});
}

Real distance(const Point& p, const Polygon& polygon) {
    const std::vector<Point> corners = corners_in_plane(polygon);
    const Point normal(polygon.normal);
    const Real size = length(normal), off = dot(normal, p - Point(polygon.centre)) / size;
    if (inside(corners, p - (off / size) * normal, polygon.axis)) return abs(off);
    Real least = length(p - corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i)
        least =
            std::min(least, distance_to_segment(p, corners[i], corners[(i + 1) % corners.size()]));
    return least;
}

std::vector<Real> meetings(const Ray& ray, const Triangle& triangle) {
    const Point a(triangle.a), e1 = Point(triangle.b) - a, e2 = Point(triangle.c) - a;
    const Point d(ray.direction), s = Point(ray.origin) - a;
    const Point p = cross(d, e2), q = cross(s, e1);
    const Real det = dot(e1, p);
    if (det == 0) return {};
    const Real u = dot(s, p) / det, v = dot(d, q) / det;
    if (u < 0 || v < 0 || u + v > 1) return {};
    return {dot(e2, q) / det};
}

std::vector<Real> meetings(const Ray& ray, const Sphere& sphere) {
    const Point d(ray.direction), from = Point(ray.origin) - Point(sphere.centre);
    const Real a = dot(d, d), b = dot(from, d);
    const Real c = dot(from, from) - Real(sphere.radius) * sphere.radius;
    const Real discriminant = b * b - a * c;
    if (discriminant < 0) return {};
    const Real root = sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
}

std::vector<Real> meetings(const Ray& ray, const Frustum& frustum) {
    const Point base(frustum.base), axis = Point(frustum.apex) - base;
    const Point d(ray.direction), from = Point(ray.origin) - base;
    const Real size = length(axis);
    const Real slope = (Real(frustum.apex_radius) - Real(frustum.base_radius)) / size;
    const Real height = dot(from, axis) / size, climb = dot(d, axis) / size;
    const Real radius = Real(frustum.base_radius) + slope * height, growth = slope * climb;
    const Point p = from - (height / size) * axis, q = d - (climb / size) * axis;
    const Real a = dot(q, q) - growth * growth, b = dot(p, q) - radius * growth;
    const Real c = dot(p, p) - radius * radius, discriminant = b * b - a * c;
    std::vector<Real> all;
    if (discriminant < 0 || a == 0) return all;
    const Real root = sqrt(discriminant);
    for (const Real& t : {Real((-b - root) / a), Real((-b + root) / a)})
        if (height + t * climb >= 0 && height + t * climb <= size) all.push_back(t);
    return all;
}

}  // namespace rayshoot::truth
