#include "tracer/integrator/irradiance_cache.h"

#include <gtest/gtest.h>

namespace rayshoot {
namespace {

constexpr vec3 up{0, 0, 1};

IrradianceRecord record(const vec3& position, float irradiance, float distance) {
    return {position, up, vec3(irradiance), distance};
}

TEST(IrradianceCache, knows_nothing_at_first) {
    EXPECT_EQ(IrradianceCache(0.2f).irradiance(vec3(0), up), std::nullopt);
}

TEST(IrradianceCache, a_record_serves_as_far_as_its_error_allows) {
    IrradianceCache cache(0.2f);
    cache.insert(record(vec3(0), 3, 10));
    EXPECT_EQ(cache.irradiance({1.99f, 0, 0}, up), vec3(3));
    EXPECT_EQ(cache.irradiance({2.01f, 0, 0}, up), std::nullopt);
    EXPECT_EQ(cache.irradiance(vec3(0), up), vec3(3));
}

TEST(IrradianceCache, a_turned_normal_costs_as_ward_says) {
    IrradianceCache cache(0.2f);
    cache.insert(record(vec3(0), 3, 10));
    const auto turned = [](float cosine) {
        return vec3(std::sqrt(1 - cosine * cosine), 0, cosine);
    };
    EXPECT_TRUE(cache.irradiance(vec3(0), turned(0.961f)));   // sqrt(1 - 0.961) < 0.2
    EXPECT_FALSE(cache.irradiance(vec3(0), turned(0.959f)));  // sqrt(1 - 0.959) > 0.2
}

TEST(IrradianceCache, weighs_records_by_the_inverse_of_their_error) {
    IrradianceCache cache(0.5f);
    cache.insert(record({-1, 0, 0}, 1, 10));  // at 0 off by 0.1
    cache.insert(record({3, 0, 0}, 5, 10));   // at 0 off by 0.3
    const auto found = cache.irradiance(vec3(0), up);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->x, (1 / 0.1 + 5 / 0.3) / (1 / 0.1 + 1 / 0.3), 1e-4);
}

TEST(IrradianceCache, leaves_out_records_in_front_of_a_point) {
    IrradianceCache cache(0.5f);
    cache.insert(record({0, 0, 1}, 3, 10));
    EXPECT_EQ(cache.irradiance(vec3(0), up), std::nullopt);
    EXPECT_TRUE(cache.irradiance({0, 0, 2}, up));
}

TEST(IrradianceCache, refuses_an_error_that_is_none) {
    for (const float error : {0.0f, -1.0f, 1.5f, std::nanf("")})
        EXPECT_THROW(IrradianceCache cache(error), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
