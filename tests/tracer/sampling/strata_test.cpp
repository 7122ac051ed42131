#include "tracer/sampling/strata.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracer/sampling/chi_squared.h"
#include "tracer/random.h"
#include "tracer/sampling/truncated_gaussian.h"

namespace rayshoot {
namespace {

std::uint32_t stratum(float value, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::floor(double{value} * count));
}

TEST(Strata, the_ends_of_each_stratum_lie_in_it) {
    for (const std::uint32_t count : {1u, 2u, 3u, 5u, 7u, 256u, 1000u, 65521u, 65535u, 65536u}) {
        const Strata strata(count);
        for (std::uint32_t i = 0; i < count; ++i) {
            const float first = strata.point(i, 0), last = strata.point(i, ~0u);
            ASSERT_EQ(stratum(first, count), i);
            ASSERT_EQ(stratum(last, count), i);
            ASSERT_LT(last, 1.0f);
            // Nothing is left out: the next multiple of 2^-24 is the next stratum's first.
            if (i + 1 < count) {
                ASSERT_EQ(last + 0x1p-24f, strata.point(i + 1, 0));
            }
        }
        EXPECT_EQ(strata.point(0, 0), 0.0f);
        EXPECT_EQ(strata.point(count - 1, ~0u), 1 - 0x1p-24f);
    }
}

TEST(Strata, quotients_are_exact) {
    for (std::uint32_t count = 1; count <= Strata::largest_count; count = count * 5 / 4 + 1) {
        const Strata strata(count);
        for (std::uint32_t i = 0; i <= Strata::largest_count; ++i) {
            ASSERT_EQ(strata.quotient(i), i / count) << i << " / " << count;
        }
    }
}

TEST(Strata, the_middle_is_the_middle) {
    EXPECT_EQ(Strata(1).point(0, 1u << 31), 0.5f);
    EXPECT_EQ(Strata(4).point(1, 1u << 31), 0.375f);
    EXPECT_NEAR(Strata(3).point(1, 1u << 31), 0.5f, 0x1p-24f);
}

double gaussian_distribution(double x) {
    const double end = std::erf(std::sqrt(2.0));  // two deviations
    const double deviations = (x - 0.5) / TruncatedGaussian::deviation;
    return 0.5 + std::erf(deviations / std::sqrt(2.0)) / (2 * end);
}

TEST(TruncatedGaussian, inverts_the_distribution) {
    const TruncatedGaussian gaussian;
    std::uint32_t last = 0;
    for (std::uint64_t uniform = 0; uniform < 1ull << 32; uniform += 99991) {
        const std::uint32_t value = gaussian(static_cast<std::uint32_t>(uniform));
        EXPECT_NEAR(gaussian_distribution(value * 0x1p-32), static_cast<double>(uniform) * 0x1p-32,
                    1e-5);
        EXPECT_GE(value, last);
        last = value;
    }
}

/// Null hypothesis: the truncated Gaussian, 10^6 numbers, 200 bins.
TEST(TruncatedGaussian, has_its_density) {
    const TruncatedGaussian gaussian;
    constexpr std::size_t bins = 200;
    Histogram histogram(bins);
    for (std::uint64_t i = 0; i < 1000000; ++i) {
        const auto uniform = static_cast<std::uint32_t>(scrambled(i) >> 32);
        histogram.add(gaussian(uniform) * std::uint64_t{bins} >> 32);
    }
    EXPECT_TRUE(histogram.agrees([](std::size_t bin) {
        const auto lo = static_cast<double>(bin) / bins;
        return gaussian_distribution(lo + 1.0 / bins) - gaussian_distribution(lo);
    }));
}

TEST(TruncatedGaussian, is_symmetric) {
    const TruncatedGaussian gaussian;
    EXPECT_EQ(gaussian(1u << 31), 1u << 31);
    EXPECT_EQ(gaussian(0), 0u);
    for (std::uint32_t i = 1; i < 1000; ++i) {
        const std::uint32_t uniform = i * 4294967;
        EXPECT_NEAR(gaussian(uniform) * 0x1p-32 + gaussian(0u - uniform) * 0x1p-32, 1, 1e-9);
    }
}

}  // namespace
}  // namespace rayshoot
