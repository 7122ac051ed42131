#include <gtest/gtest.h>

#include "accel/core/leaves.h"
#include "tests/core/cases.h"

/// Multiplying a scene by a power of two multiplies every t by it and changes nothing else, to the
/// last bit: no threshold has a unit.
namespace rayshoot {
namespace {

Triangle times(const Triangle& t, float s) { return {s * t.a, s * t.b, s * t.c}; }
Sphere times(const Sphere& p, float s) { return {s * p.centre, s * p.radius}; }
Frustum times(const Frustum& f, float s) {
    return {s * f.base, s * f.base_radius, s * f.apex, s * f.apex_radius};
}
Polygon times(const Polygon& p, float s) {
    std::vector<vec3> corners = p.corners;
    for (vec3& corner : corners) corner *= s;
    return make_polygon(corners, {});
}

using Answer = std::array<float, 3>;

template <class Shape, class Test>
std::vector<Answer> ask(const Shape& shape, const Ray& ray, Test&& test) {
    std::vector<Answer> all;
    test(shape, TestRay(ray, Precision::watertight), [&](float t, float u, float v) {
        if (!std::isnan(t)) all.push_back({t, u, v});
    });
    return all;
}

/// `farthest`: exponent up to which the arithmetic keeps every bit.
template <class Make, class Test>
void expect_scales(std::uint64_t seed, int farthest, Make&& make, Test&& test) {
    cases::Random random(seed);
    std::size_t hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto shape = make(random);
        const Ray ray = cases::ray_at(cases::spot_on(shape, random), 1, random);
        const auto plain = ask(shape, ray, test);
        hits += plain.size();
        for (int exponent = -farthest; exponent <= farthest; exponent += 5) {
            const float scale = std::ldexp(1.0f, exponent);
            Ray scaled = ray;
            scaled.origin *= scale;
            auto wanted = plain;
            for (Answer& answer : wanted) answer[0] *= scale;
            ASSERT_EQ(ask(times(shape, scale), scaled, test), wanted)
                << cases::print(ray) << " times 2^" << exponent;
        }
    }
    EXPECT_GT(hits, 1000u);
}

constexpr auto ordinary = [](const auto& shape, const TestRay& ray, auto&& accept) {
    intersect(shape, ray, accept);
};
constexpr auto watertight = [](const Triangle& triangle, const TestRay& ray, auto&& accept) {
    intersect_watertight(triangle, ray, accept);
};

// The float test of a triangle hands over to double outside [2^-80, 2^80], that of a sphere
// outside [2^-25, 2^25]: both are exact only between.
TEST(Scale, triangles) { expect_scales(51, 10, cases::triangle, ordinary); }
TEST(Scale, watertight_triangles) { expect_scales(52, 10, cases::triangle, watertight); }
TEST(Scale, frusta) { expect_scales(54, 60, cases::frustum, ordinary); }
TEST(Scale, polygons) { expect_scales(55, 60, cases::polygon, ordinary); }

TEST(Scale, spheres) {
    const auto near_origin = [](cases::Random& random) {
        return Sphere{random.in_cube(1), static_cast<float>(random.magnitude(-4, 2))};
    };
    const auto in_reach = [](const Sphere& sphere, const TestRay& ray, auto&& accept) {
        const float distance = taxicab(ray.origin - sphere.centre);
        const float low = ray.direction_size;
        if (distance < 64 * sphere.radius && low > 0x1p-20f && low < 0x1p20f)
            intersect(sphere, ray, accept);
    };
    expect_scales(53, 10, near_origin, in_reach);
}

}  // namespace
}  // namespace rayshoot
