#include "accel/core/neighbour.h"
#include "accel/core/vec.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

/// Bit tricks against the standard library's slower functions.
namespace rayshoot {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

TEST(Neighbour, is_what_nextafter_says) {
    for (std::uint64_t bits = 0; bits <= 0xffffffff; bits += 251) {
        const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        if (std::isnan(x)) continue;
        ASSERT_EQ(float_below(x), std::nextafter(x, -infinite)) << x;
        ASSERT_EQ(float_above(x), std::nextafter(x, infinite)) << x;
    }
}

TEST(Neighbour, of_zero_infinity_and_the_ends_of_each_range) {
    using Limits = std::numeric_limits<float>;
    for (const float size :
         {0.0f, Limits::denorm_min(), Limits::min(), 1.0f, Limits::max(), infinite})
        for (const float x : {size, -size}) {
            EXPECT_EQ(float_below(x), std::nextafter(x, -infinite)) << x;
            EXPECT_EQ(float_above(x), std::nextafter(x, infinite)) << x;
        }
}

TEST(Finite, fails_for_one_infinity_or_nan_wherever_it_stands) {
    using Limits = std::numeric_limits<float>;
    EXPECT_TRUE(finite(vec3(Limits::max(), -Limits::max(), Limits::denorm_min())));
    for (int axis = 0; axis < 3; ++axis)
        for (const float bad : {infinite, -infinite, std::nanf("")}) {
            vec3 p(1, -2, 3);
            p[axis] = bad;
            EXPECT_FALSE(finite(p)) << axis << ' ' << bad;
        }
}

}  // namespace
}  // namespace rayshoot
