#pragma once

#include <cstdint>
#include <string>

#include "accel/core/geometry.h"

/// Seeded primitives and rays that are hard on their tests. Same numbers with every compiler: so
/// no expression draws twice, as the order would be unspecified.
namespace rayshoot::cases {

/// SplitMix64 (Steele, Lea & Flood 2014).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits();
    std::uint32_t below(std::uint32_t count);
    double uniform(double lo, double hi);
    /// 2^x with x uniform; exact powers of two apart from a factor in [1, 2).
    double magnitude(int lowest, int highest);
    vec3 in_cube(double half_width);
    dvec3 unit();

private:
    std::uint64_t state_;
};

Triangle triangle(Random& random);  ///< every other one skinny, some far from the origin
Sphere sphere(Random& random);
Frustum frustum(
    Random& random);  ///< cones, cylinders, needles, flat ones, some parallel to an axis
Polygon polygon(Random& random);  ///< convex and star-shaped concave, 4 to 24 corners

/// A point of the surface and the surface's unit normal there.
struct Spot {
    dvec3 point, normal;
};
Spot spot_on(const Triangle& triangle, Random& random);
Spot spot_on(const Sphere& sphere, Random& random);
Spot spot_on(const Frustum& frustum, Random& random);
Spot spot_on(const Polygon& polygon, Random& random);

/// A ray through or near a spot of a shape of the given size: from near or far, steep, grazing or
/// axis-parallel, with a direction of any length.
Ray ray_at(const Spot& spot, double size, Random& random);

/// The point of a shape that is outermost in a direction along an axis.
dvec3 outermost(const Triangle& triangle, const dvec3& outward);
dvec3 outermost(const Sphere& sphere, const dvec3& outward);
dvec3 outermost(const Frustum& frustum, const dvec3& outward);
dvec3 outermost(const Polygon& polygon, const dvec3& outward);

/// A ray from `away` that passes such a point of a shape of the given size by a rounding or so,
/// nearly along the face of the shape's bounds.
Ray ray_past(const dvec3& point, const dvec3& outward, double size, double away, Random& random);
/// Past any of the shape's outermost points, from at most 2^`farthest` sizes away.
template <class Shape>
Ray ray_past_an_end(const Shape& shape, double size, int farthest, Random& random) {
    dvec3 outward(0);
    outward[static_cast<int>(random.below(3))] = random.below(2) ? 1 : -1;
    const double away = size * random.magnitude(-3, farthest);
    return ray_past(outermost(shape, outward), outward, size, away, random);
}
/// Whether the test in Precision::standard takes a hit back because the clamp to the triangle's
/// bounds moves it too far.
bool is_taken_back(const Triangle& triangle, const Box& bounds, const Ray& ray);

/// Add to a geometry that holds nothing else.
Geometry alone(const Triangle& triangle, Precision precision = Precision::standard);
Geometry alone(const Sphere& sphere);
Geometry alone(const Frustum& frustum);
Geometry alone(const Polygon& polygon);

/// Of a box: the length of its diagonal.
double diagonal(const Box& box);
/// Of a ray's direction.
double length_of(const Ray& ray);
/// All of a ray, in hexadecimal floats, to be pasted into a test.
std::string print(const Ray& ray);

}  // namespace rayshoot::cases
