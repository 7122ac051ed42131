#include <gtest/gtest.h>

#include "accel/core/primitive/sphere.h"
#include "tests/core/cases.h"
#include "tests/core/truth.h"

namespace rayshoot {
namespace {

std::vector<float> ask(const Sphere& sphere, const Ray& ray) {
    std::vector<float> all;
    intersect(sphere, TestRay(ray, Precision::standard), [&](float t, float, float) {
        if (!std::isnan(t)) all.push_back(t);
    });
    return all;
}

/// Whether the line clearly meets or misses the sphere, seen from where it starts.
TEST(Sphere, clear_hits_and_misses_agree_with_high_precision) {
    cases::Random random(21);
    int hits = 0, misses = 0;
    for (int i = 0; i < 100000; ++i) {
        const Sphere sphere = cases::sphere(random);
        Ray ray = cases::ray_at(cases::spot_on(sphere, random), 2.0 * sphere.radius, random);
        if (random.below(3) == 0) ray.direction += random.in_cube(0.3 * cases::length_of(ray));
        if (!answerable(ray)) continue;
        const truth::Point d(ray.direction), from(ray.origin - sphere.centre);
        const double off =
            static_cast<double>(truth::length(truth::cross(from, d)) / truth::length(d));
        const double doubt = 16 * 0x1p-24 * static_cast<double>(truth::length(from));
        if (std::abs(off - double(sphere.radius)) < doubt) continue;
        const bool expected = off < double(sphere.radius);
        ASSERT_EQ(ask(sphere, ray).size(), expected ? 2u : 0u) << cases::print(ray);
        ++(expected ? hits : misses);
    }
    EXPECT_GT(hits, 20000);
    EXPECT_GT(misses, 5000);
}

TEST(Sphere, reports_both_exact_roots_on_a_grid) {
    const Sphere sphere{{1, 2, 3}, 2};
    Ray ray;
    ray.origin = {1, 2, -7};
    ray.direction = {0, 0, 4};
    EXPECT_EQ(ask(sphere, ray), (std::vector<float>{2, 3}));
    ray.origin = {1, 2, 3};
    EXPECT_EQ(ask(sphere, ray).size(), 2u);
    EXPECT_EQ(std::abs(ask(sphere, ray)[0]), 0.5f);
}

TEST(Sphere, is_met_at_every_scale) {
    for (const float scale : {1e-36f, 1e-20f, 1e-6f, 1.0f, 1e6f, 1e20f, 1e36f}) {
        Ray ray;
        ray.origin = vec3(0, 0, -3 * scale);
        ray.direction = vec3(0, 0, scale);
        const auto all = ask(Sphere{vec3(0), scale}, ray);
        ASSERT_EQ(all.size(), 2u) << scale;
        EXPECT_FLOAT_EQ(std::min(all[0], all[1]), 2);
        EXPECT_FLOAT_EQ(std::max(all[0], all[1]), 4);
    }
}

}  // namespace
}  // namespace rayshoot
