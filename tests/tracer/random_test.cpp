#include <gtest/gtest.h>

#include <array>
#include <set>

#include "tracer/random.h"

namespace rayshoot {
namespace {

constexpr int bins = 64;
constexpr int samples = 1 << 16;
/// Null hypothesis: uniform. chi^2 with 63 degrees of freedom exceeds this once in 10^4 tests; the
/// numbers are fixed, so the verdict is too.
constexpr double chi_squared_limit = 110.1;

template <class Number>
double chi_squared(Number&& number) {
    std::array<int, bins> counts{};
    for (std::uint32_t i = 0; i < samples; ++i) {
        ++counts[static_cast<std::size_t>(number(i) * bins)];
    }
    constexpr double expected = double{samples} / bins;
    double sum = 0;
    for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
    return sum;
}

TEST(Random, numbers_lie_in_the_half_open_unit_interval) {
    const RandomSequence random(1, 2, 3);
    for (std::uint32_t i = 0; i < samples; ++i) {
        EXPECT_GE(random.number(i), 0.0f);
        EXPECT_LT(random.number(i), 1.0f);
    }
}

TEST(Random, uniform_over_dimensions) {
    const RandomSequence random(7, 1000, 0);
    EXPECT_LT(chi_squared([&](std::uint32_t i) { return random.number(i); }), chi_squared_limit);
}

TEST(Random, uniform_over_pixels) {
    EXPECT_LT(chi_squared([](std::uint32_t i) { return RandomSequence(7, i, 0).number(0); }),
              chi_squared_limit);
}

TEST(Random, uniform_over_samples) {
    EXPECT_LT(chi_squared([](std::uint32_t i) { return RandomSequence(7, 5, i).number(1); }),
              chi_squared_limit);
}

TEST(Random, uniform_over_seeds) {
    EXPECT_LT(chi_squared([](std::uint32_t i) { return RandomSequence(i, 5, 0).number(0); }),
              chi_squared_limit);
}

/// Null hypothesis: neighbouring dimensions are independent (8 x 8 cells).
TEST(Random, neighbouring_dimensions_are_independent) {
    const auto cell = [](std::uint32_t i) {
        const RandomSequence random(7, i, 0);
        const auto x = static_cast<int>(random.number(0) * 8);
        const auto y = static_cast<int>(random.number(1) * 8);
        return static_cast<double>(8 * y + x) / bins;
    };
    EXPECT_LT(chi_squared(cell), chi_squared_limit);
}

/// The same for neighbouring pixels.
TEST(Random, neighbouring_pixels_are_independent) {
    const auto cell = [](std::uint32_t i) {
        const auto x = static_cast<int>(RandomSequence(7, 2 * i, 0).number(0) * 8);
        const auto y = static_cast<int>(RandomSequence(7, 2 * i + 1, 0).number(0) * 8);
        return static_cast<double>(8 * y + x) / bins;
    };
    EXPECT_LT(chi_squared(cell), chi_squared_limit);
}

TEST(Random, pixel_and_sample_are_not_interchangeable) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t pixel = 0; pixel < 16; ++pixel) {
        for (std::uint32_t sample = 0; sample < 16; ++sample) {
            seen.insert(RandomSequence(0, pixel, sample).bits(0));
        }
    }
    EXPECT_EQ(seen.size(), 256u);
}

TEST(Random, numbers_never_change) {
    EXPECT_EQ(RandomSequence(0, 0, 0).bits(0), 1451924235u);
    EXPECT_EQ(RandomSequence(1, 2, 3).bits(4), 4260197056u);
}

}  // namespace
}  // namespace rayshoot
