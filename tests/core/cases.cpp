#include "tests/core/cases.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

#include "accel/core/leaves.h"
#include "accel/core/primitive/extent.h"

namespace rayshoot::cases {
namespace {

/// Two unit vectors across a third.
std::array<dvec3, 2> across(const dvec3& n) {
    const dvec3 helper = std::abs(n.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 u = normalised(cross(n, helper));
    return {u, cross(n, u)};
}

vec3 place(Random& random) {
    return random.below(4) == 0 ? random.in_cube(random.magnitude(0, 10)) : random.in_cube(1);
}

}  // namespace

std::uint64_t Random::bits() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

std::uint32_t Random::below(std::uint32_t count) {
    return static_cast<std::uint32_t>((bits() >> 32) * count >> 32);
}

double Random::uniform(double lo, double hi) {
    return std::fma(hi - lo, static_cast<double>(bits() >> 11) * 0x1p-53, lo);
}

double Random::magnitude(int lowest, int highest) {
    const int exponent =
        lowest + static_cast<int>(below(static_cast<std::uint32_t>(highest - lowest)));
    return std::ldexp(uniform(1, 2), exponent);
}

vec3 Random::in_cube(double half_width) {
    const double x = uniform(-half_width, half_width), y = uniform(-half_width, half_width);
    return vec3(dvec3(x, y, uniform(-half_width, half_width)));
}

dvec3 Random::unit() {
    for (;;) {
        const double x = uniform(-1, 1), y = uniform(-1, 1);
        const dvec3 p(x, y, uniform(-1, 1));
        const double size = length(p);
        if (size > 0.01 && size < 1) return p / size;
    }
}

Triangle triangle(Random& random) {
    const vec3 a = place(random);
    const dvec3 e1 = random.unit();
    const double skinny = random.below(2) ? random.magnitude(-12, 0) : 1;
    const double lean = random.uniform(-1, 2);
    const dvec3 e2 = lean * e1 + skinny * random.unit();
    return {a, vec3(dvec3(a) + e1), vec3(dvec3(a) + e2)};
}

Sphere sphere(Random& random) {
    return {place(random), static_cast<float>(random.magnitude(-8, 2))};
}

Frustum frustum(Random& random) {
    Frustum f;
    f.base = place(random);
    const double size = random.magnitude(-6, 3);
    dvec3 axis = size * random.unit();
    if (random.below(4) == 0) axis = {0, 0, axis.z};
    f.apex = vec3(dvec3(f.base) + axis);
    const double radius = random.magnitude(-6, 2);
    f.base_radius = random.below(6) == 0 ? 0 : static_cast<float>(radius);
    f.apex_radius = random.below(3) == 0 ? 0 : static_cast<float>(radius * random.uniform(0, 2));
    if (random.below(4) == 0) f.apex_radius = f.base_radius;
    if (f.base_radius == 0 && f.apex_radius == 0) f.apex_radius = static_cast<float>(radius);
    return f;
}

Polygon polygon(Random& random) {
    const vec3 centre = place(random);
    dvec3 normal = random.unit();
    if (random.below(4) == 0) normal = {0, 0, 1};
    const auto [u, v] = across(normal);
    const std::uint32_t count = 4 + random.below(21);
    std::vector<vec3> corners;
    dvec3 turn(1, 0, 0);  // (cos, sin): rotated by a rational rotation, so without libm
    const double t = 3.0 / count, c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    for (std::uint32_t i = 0; i < count; ++i) {
        const double radius = random.below(3) == 0 ? random.uniform(0.2, 1) : 1;
        corners.push_back(vec3(dvec3(centre) + radius * (turn.x * u + turn.y * v)));
        turn = {c * turn.x - s * turn.y, s * turn.x + c * turn.y, 0};
    }
    return make_polygon(corners, {});
}

Spot spot_on(const Triangle& triangle, Random& random) {
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    if (random.below(4) == 0) v = 0;  // on an edge
    const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
    return {a + u * e1 + v * e2, dvec3(geometric_normal(triangle))};
}

Spot spot_on(const Sphere& sphere, Random& random) {
    const dvec3 n = random.unit();
    return {dvec3(sphere.centre) + double(sphere.radius) * n, n};
}

Spot spot_on(const Frustum& frustum, Random& random) {
    const dvec3 axis = dvec3(frustum.apex) - dvec3(frustum.base);
    const double size = length(axis), share = random.uniform(0, 1);
    const auto [u, v] = across(axis / size);
    const dvec3 turn = random.unit();
    const dvec3 radial = normalised(turn.x * u + turn.y * v);
    const double slope = (double(frustum.apex_radius) - double(frustum.base_radius)) / size;
    const double radius = double(frustum.base_radius) + share * size * slope;
    return {dvec3(frustum.base) + share * axis + radius * radial,
            normalised(radial - slope * (axis / size))};
}

Spot spot_on(const Polygon& polygon, Random& random) {
    const auto count = static_cast<std::uint32_t>(polygon.corners.size());
    const std::uint32_t i = random.below(count);
    const dvec3 a = flattened(polygon, polygon.corners[i]);
    const dvec3 b = flattened(polygon, polygon.corners[(i + 1) % count]);
    // Star-shaped round its centre, nearly: so this is inside or close to an edge.
    const dvec3 edge = a + random.uniform(0, 1) * (b - a);
    const double inward = random.below(4) == 0 ? 1 : random.uniform(0, 1);
    return {polygon.centre + inward * (edge - polygon.centre),
            polygon.normal / length(polygon.normal)};
}

Ray ray_at(const Spot& spot, double size, Random& random) {
    const auto [u, v] = across(spot.normal);
    const dvec3 turn = random.unit();
    const dvec3 tangent = normalised(turn.x * u + turn.y * v);
    dvec3 direction = random.unit();
    const std::uint32_t choice = random.below(8);
    if (choice < 3) direction = tangent + random.magnitude(-16, 0) * spot.normal;
    if (choice == 3) {
        direction = dvec3(0);
        direction[static_cast<int>(random.below(3))] = random.below(2) ? 1 : -1;
    }
    const double away = size * random.magnitude(-3, random.below(3) ? 3 : 20);
    dvec3 target = spot.point;
    if (random.below(4) == 0) {
        const double off = size * random.magnitude(-26, -8);
        target += off * random.unit();
    }
    Ray ray;
    ray.origin = vec3(target - away * direction);
    ray.t_min = -infinity;
    dvec3 aim = target - dvec3(ray.origin);
    if (choice == 3 || !(length(aim) > 0)) aim = direction;
    ray.direction = vec3(aim * (random.below(2) ? random.magnitude(-10, 10) : 1.0));
    return ray;
}

namespace {

dvec3 outermost(std::span<const vec3> corners, const dvec3& outward) {
    return dvec3(
        *std::max_element(corners.begin(), corners.end(), [&](const vec3& a, const vec3& b) {
            return dot(dvec3(a), outward) < dot(dvec3(b), outward);
        }));
}

}  // namespace

dvec3 outermost(const Triangle& triangle, const dvec3& outward) {
    return outermost(std::array{triangle.a, triangle.b, triangle.c}, outward);
}

dvec3 outermost(const Sphere& sphere, const dvec3& outward) {
    return dvec3(sphere.centre) + double(sphere.radius) * outward;
}

dvec3 outermost(const Frustum& frustum, const dvec3& outward) {
    const dvec3 axis = normalised(dvec3(frustum.apex) - dvec3(frustum.base));
    const dvec3 radial = outward - dot(outward, axis) * axis;
    const dvec3 step = length(radial) > 0 ? normalised(radial) : dvec3(0);
    const dvec3 base = dvec3(frustum.base) + double(frustum.base_radius) * step;
    const dvec3 apex = dvec3(frustum.apex) + double(frustum.apex_radius) * step;
    return dot(base, outward) > dot(apex, outward) ? base : apex;
}

dvec3 outermost(const Polygon& polygon, const dvec3& outward) {
    return outermost(std::span(polygon.corners), outward);
}

Ray ray_past(const dvec3& point, const dvec3& outward, double size, double away, Random& random) {
    const auto [u, v] = across(outward);
    const dvec3 turn = random.unit();
    const dvec3 along_face = normalised(turn.x * u + turn.y * v);
    const double descent = random.magnitude(-24, -3), passed = size * random.magnitude(-28, -14);
    const dvec3 direction = along_face - descent * outward;
    Ray ray;
    ray.origin = vec3(point + passed * outward - away * direction);
    ray.t_min = -infinity;
    ray.direction = vec3((random.below(2) ? random.magnitude(-10, 10) : 1.0) * direction);
    return ray;
}

bool is_taken_back(const Triangle& triangle, const Box& bounds, const Ray& ray) {
    bool taken = false;
    const TestRay prepared(ray, Precision::standard);
    meet(triangle, prepared, [&](float t, float, float, auto&& strays) {
        const Interval interval = clip(prepared, bounds);
        taken = !interval.empty() && strays(interval.clamp(t));
    });
    return taken;
}

Geometry alone(const Triangle& triangle, Precision precision) {
    GeometryBuilder builder;
    builder.add_triangle(triangle.a, triangle.b, triangle.c);
    return std::move(builder).build(precision);
}

Geometry alone(const Sphere& sphere) {
    GeometryBuilder builder;
    builder.add_sphere(sphere);
    return std::move(builder).build();
}

Geometry alone(const Frustum& frustum) {
    GeometryBuilder builder;
    builder.add_frustum(frustum);
    return std::move(builder).build();
}

Geometry alone(const Polygon& polygon) {
    GeometryBuilder builder;
    builder.add_polygon(polygon.corners, polygon.normals);
    return std::move(builder).build();
}

double diagonal(const Box& box) { return length(dvec3(box.hi) - dvec3(box.lo)); }

double length_of(const Ray& ray) { return length(dvec3(ray.direction)); }

std::string print(const Ray& ray) {
    char text[256];
    std::snprintf(text, sizeof text, "origin {%a, %a, %a} direction {%a, %a, %a}",
                  double(ray.origin.x), double(ray.origin.y), double(ray.origin.z),
                  double(ray.direction.x), double(ray.direction.y), double(ray.direction.z));
    return text;
}

}  // namespace rayshoot::cases
