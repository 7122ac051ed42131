#include <gtest/gtest.h>

#include <algorithm>

#include "accel/core/primitive/frustum.h"
#include "tests/core/cases.h"
#include "tests/core/truth.h"

namespace rayshoot {
namespace {

std::vector<float> ask(const Frustum& frustum, const Ray& ray) {
    std::vector<float> all;
    intersect(frustum, TestRay(ray, Precision::standard),
              [&](float t, float, float) { all.push_back(t); });
    std::sort(all.begin(), all.end());
    return all;
}

Ray ray_from(const vec3& origin, const vec3& direction) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    return ray;
}

/// A crossing is clear when it is far from the rims and the line crosses the surface at an angle.
bool clear(const Frustum& frustum, const Ray& ray, const truth::Real& t) {
    const truth::Point p = truth::Point(ray.origin) + t * truth::Point(ray.direction);
    const truth::Point base(frustum.base), axis = truth::Point(frustum.apex) - base;
    const double size = static_cast<double>(truth::length(axis));
    const double share = static_cast<double>(truth::dot(p - base, axis)) / (size * size);
    const vec3 near(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z));
    const dvec3 normal(normal_at(frustum, near));
    const double angle = std::abs(dot(normal, normalised(dvec3(ray.direction))));
    return share > 1e-6 && share < 1 - 1e-6 && angle > 1e-3;
}

TEST(Frustum, crossings_agree_with_high_precision) {
    cases::Random random(31);
    int compared = 0, lone = 0;
    for (int i = 0; i < 100000; ++i) {
        const Frustum frustum = cases::frustum(random);
        const double size = cases::diagonal(bounds(frustum));
        const Ray ray = cases::ray_at(cases::spot_on(frustum, random), size, random);
        const auto expected = truth::meetings(ray, frustum);
        const auto found = ask(frustum, ray);
        if (std::any_of(expected.begin(), expected.end(),
                        [&](const truth::Real& t) { return !clear(frustum, ray, t); }))
            continue;
        for (const truth::Real& t : expected) {
            const double wanted = static_cast<double>(t);
            const double doubt =
                0x1p-23 * std::abs(wanted) + 0x1p-20 * size / length(dvec3(ray.direction));
            const bool there = std::any_of(found.begin(), found.end(), [&](float f) {
                return std::abs(double(f) - wanted) <= doubt;
            });
            ASSERT_TRUE(there) << cases::print(ray) << " t " << wanted;
            ++compared;
        }
        lone += expected.size() == 1;
    }
    EXPECT_GT(compared, 50000);
    EXPECT_GT(lone, 5000);
}

TEST(Frustum, lines_that_miss_are_told_so) {
    cases::Random random(32);
    int misses = 0;
    for (int i = 0; i < 50000; ++i) {
        const Frustum frustum = cases::frustum(random);
        const double size = cases::diagonal(bounds(frustum));
        Ray ray = cases::ray_at(cases::spot_on(frustum, random), size, random);
        ray.direction += random.in_cube(cases::length_of(ray));
        if (!answerable(ray) || !truth::meetings(ray, frustum).empty()) continue;
        ++misses;
        for (const float t : ask(frustum, ray))  // at best a crossing within rounding
            EXPECT_LT(truth::distance(truth::point_at(ray, t), frustum),
                      0x1p-20 * (size + double(length(ray.origin - frustum.base))))
                << cases::print(ray);
    }
    EXPECT_GT(misses, 10000);
}

TEST(Frustum, cylinder_is_hit_on_both_sides_and_not_on_its_ends) {
    const Frustum cylinder{{0, 0, 0}, 1, {0, 0, 2}, 1};
    EXPECT_EQ(ask(cylinder, ray_from({-3, 0, 1}, {1, 0, 0})), (std::vector<float>{2, 4}));
    EXPECT_EQ(ask(cylinder, ray_from({0.5f, 0, -1}, {0, 0, 1})), std::vector<float>{});
    EXPECT_EQ(ask(cylinder, ray_from({-3, 0, 2.5f}, {1, 0, 0})), std::vector<float>{});
}

TEST(Frustum, cone_has_one_nappe) {
    const Frustum cone{{0, 0, 0}, 1, {0, 0, 2}, 0};
    EXPECT_EQ(ask(cone, ray_from({-3, 0, 1}, {1, 0, 0})), (std::vector<float>{2.5f, 3.5f}));
    EXPECT_EQ(ask(cone, ray_from({-3, 0, 3}, {1, 0, 0})), std::vector<float>{});
    EXPECT_EQ(ask(cone, ray_from({0.25f, 0, -1}, {0, 0, 1})), std::vector<float>{2.5f});
}

TEST(Frustum, tip_of_a_cone_is_part_of_it) {
    const Frustum cone{{0, 0, 0}, 1, {0, 0, 2}, 0};
    const auto found = ask(cone, ray_from({0, 0, -1}, {0, 0, 1}));
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front(), 3);
}

TEST(Frustum, degenerate_ones_are_never_hit) {
    cases::Random random(33);
    for (int i = 0; i < 1000; ++i) {
        const vec3 a = random.in_cube(1), b = random.in_cube(1);
        const Ray ray = ray_from(random.in_cube(3), a - random.in_cube(1));
        EXPECT_TRUE(ask({a, 1, a, 0.5f}, ray).empty());
        EXPECT_TRUE(ask({a, 0, b, 0}, ray).empty());
    }
}

TEST(Frustum, is_met_at_every_scale) {
    for (const float s : {1e-36f, 1e-20f, 1e-6f, 1.0f, 1e6f, 1e20f, 1e36f}) {
        const Frustum cone{{0, 0, 0}, s, {0, 0, 2 * s}, 0};
        const auto found = ask(cone, ray_from({-3 * s, 0, s}, {s, 0, 0}));
        ASSERT_EQ(found.size(), 2u) << s;
        EXPECT_FLOAT_EQ(found[0], 2.5f);
        EXPECT_FLOAT_EQ(found[1], 3.5f);
    }
}

}  // namespace
}  // namespace rayshoot
