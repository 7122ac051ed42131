#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "accel/core/vec.h"

/// Solid angles and irradiances that are known. All from radiance 1.
namespace rayshoot::tracer_tests {

/// Lambert 1760: sum over the edges of the angle they subtend times the cosine between the
/// receiver's normal and that of the plane through them. The polygon must be above the horizon and
/// counter-clockwise seen from its lit side, which `from` is on.
inline double polygon_irradiance(const dvec3& from, const dvec3& normal,
                                 std::span<const dvec3> corners) {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec3 a = corners[i] - from, b = corners[(i + 1) % corners.size()] - from;
        const dvec3 plane = cross(b, a);
        const double angle = std::atan2(length(plane), dot(a, b));
        sum += angle * dot(normalised(plane), normal);
    }
    return std::abs(sum) / 2;
}

/// Van Oosterom & Strackee 1983.
inline double triangle_solid_angle(const dvec3& from, const dvec3& a, const dvec3& b,
                                   const dvec3& c) {
    const dvec3 x = a - from, y = b - from, z = c - from;
    const double lx = length(x), ly = length(y), lz = length(z);
    const double below = lx * ly * lz + dot(x, y) * lz + dot(x, z) * ly + dot(y, z) * lx;
    return std::abs(2 * std::atan2(dot(x, cross(y, z)), below));
}

/// On the axis of a disc, facing it.
inline double disc_irradiance(double radius, double height) {
    return std::numbers::pi * radius * radius / (radius * radius + height * height);
}
inline double disc_solid_angle(double radius, double height) {
    return 2 * std::numbers::pi * (1 - height / std::sqrt(radius * radius + height * height));
}

/// A sphere all above the horizon, at `cosine` with the normal.
inline double sphere_irradiance(double radius, double distance, double cosine) {
    return std::numbers::pi * cosine * radius * radius / (distance * distance);
}
inline double sphere_solid_angle(double radius, double distance) {
    const double sine = radius / distance;
    return 2 * std::numbers::pi * sine * sine / (1 + std::sqrt(1 - sine * sine));
}

}  // namespace rayshoot::tracer_tests
