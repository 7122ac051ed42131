#include "tracer/bsdf/gloss.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/tracer/bsdf/materials.h"
#include "tests/tracer/stream.h"

namespace rayshoot::tracer_tests {
namespace {

/// Null hypothesis: cos^(n + 1) of the angle with the sharp direction is uniform on [0, 1]
/// (Kolmogorov & Smirnov). N = 10 000, level 0.001.
TEST(Gloss, is_phongs_lobe_round_the_sharp_direction) {
    constexpr int count = 10'000;
    const double limit = 1.95 / std::sqrt(count);
    for (const float exponent : {1.0f, 10.0f, 500.0f}) {
        Stream random(1);
        const vec3 sharp = normalised(vec3(1, 2, 3));
        const SurfacePoint point{dvec3(0), sharp, sharp, 0};
        std::vector<double> uniform;
        for (int i = 0; i < count; ++i) {
            const BlurredRay ray = blurred(sharp, point, exponent, random.pair());
            EXPECT_NEAR(length(ray.direction), 1, 1e-6);
            uniform.push_back(std::pow(double{dot(ray.direction, sharp)}, exponent + 1.0));
        }
        std::ranges::sort(uniform);
        double furthest = 0;
        for (int i = 0; i < count; ++i) {
            const double expected = (i + 0.5) / count;
            furthest =
                std::max(furthest, std::abs(uniform[static_cast<std::size_t>(i)] - expected));
        }
        EXPECT_LT(furthest, limit) << exponent;
    }
}

TEST(Gloss, is_sharp_without_an_exponent) {
    const vec3 sharp = looking(80);
    const BlurredRay ray = blurred(sharp, SurfacePoint{}, 0, {0.3f, 0.9f});
    EXPECT_EQ(ray.direction, sharp);
    EXPECT_EQ(ray.weight, 1);
}

/// Reflected as well as refracted: clipped exactly where it would be on the other side.
TEST(Gloss, is_clipped_at_the_surface) {
    Stream random(2);
    SurfacePoint point;
    point.shading = normalised(vec3(0.3f, 0, 1));
    int clipped = 0, kept = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 sharp = looking(75, i % 2 == 0);
        const BlurredRay ray = blurred(sharp, point, 5, random.pair());
        const bool through = ray.direction.z * sharp.z <= 0 ||
                             dot(ray.direction, point.shading) * dot(sharp, point.shading) <= 0;
        EXPECT_EQ(ray.weight, through ? 0 : 1);
        ++(through ? clipped : kept);
    }
    EXPECT_GT(clipped, 200);
    EXPECT_GT(kept, 1000);
}

}  // namespace
}  // namespace rayshoot::tracer_tests
