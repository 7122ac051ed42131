#pragma once

#include <array>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "accel/core/geometry.h"

/// Distances in 113-bit arithmetic: independent of the tests they judge, and 2^60 times finer.
namespace rayshoot::truth {

using Real = boost::multiprecision::cpp_bin_float_quad;

struct Point {
    Real x, y, z;

    Point() = default;
    Point(Real a, Real b, Real c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
    explicit Point(const vec3& p) : x(p.x), y(p.y), z(p.z) {}
    explicit Point(const dvec3& p) : x(p.x), y(p.y), z(p.z) {}
    const Real& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};

Point operator+(const Point& a, const Point& b);
Point operator-(const Point& a, const Point& b);
Point operator*(const Real& s, const Point& a);
Real dot(const Point& a, const Point& b);
Point cross(const Point& a, const Point& b);
Real length(const Point& a);

/// origin + t * direction.
Point point_at(const Ray& ray, float t);

Real distance(const Point& p, const Triangle& triangle);
Real distance(const Point& p, const Sphere& sphere);
Real distance(const Point& p, const Frustum& frustum);
Real distance(const Point& p, const Polygon& polygon);

/// The line's meeting with a triangle, if it is not parallel.
std::vector<Real> meetings(const Ray& ray, const Triangle& triangle);
/// The line's two meetings with a sphere, or none.
std::vector<Real> meetings(const Ray& ray, const Sphere& sphere);
/// The line's meetings with a frustum.
std::vector<Real> meetings(const Ray& ray, const Frustum& frustum);

}  // namespace rayshoot::truth
