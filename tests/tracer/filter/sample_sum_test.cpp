#include "tracer/filter/sample_sum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracer/filter/filters.h"

namespace rayshoot {
namespace {

using filter_tests::label;

/// Printed with two decimals: `printed` is the rounded value, or a known misprint and is not.
void expect_printed(const PrintedValue& printed, double value, const std::string& what) {
    const bool agrees = std::abs(printed.value - value) <= 0.005;
    EXPECT_EQ(agrees, !printed.misprint) << what << ": " << printed.value << ", ours " << value;
}

TEST(SampleSum, the_textbook_s_table) {
    int misprints = 0;
    for (const PrintedSampleSums& row : printed_sample_sums()) {
        const Filter filter({row.kind, row.radius});
        const SampleSums sums = sample_sums(filter);
        expect_printed(row.integral, filter.integral(), label(filter) + " integral");
        expect_printed(row.least, sums.least.sum, label(filter) + " least");
        expect_printed(row.greatest, sums.greatest.sum, label(filter) + " greatest");
        misprints += row.integral.misprint + row.least.misprint + row.greatest.misprint;
    }
    EXPECT_EQ(misprints, 2);
    EXPECT_EQ(printed_sample_sums().size(), 6u);
}

struct Known {
    FilterKind kind;
    double radius, integral, least, greatest, ripple;
};

/// Computed apart from this program, by the same formula in another language, to the digits given.
TEST(SampleSum, more_digits_of_the_table) {
    using enum FilterKind;
    constexpr std::array table{
        Known{raised_cosine, 1.5, 2.101897, 0.9668383, 1.0368866, 0.014301},
        Known{raised_cosine, 1.7, 2.699770, 0.9697584, 1.0094097, 0.009491},
        Known{raised_cosine, 2.0, 3.736706, 0.9939032, 1.0138876, 0.005616},
        Known{cone, 1.5, 2.356194, 0.8940471, 1.0873878, 0.043080},
        Known{cone, 1.7, 3.026401, 0.9477663, 1.0968466, 0.032819},
        Known{cone, 2.0, 4.188790, 0.9813273, 1.0172940, 0.008755},
    };
    for (const Known& known : table) {
        const Filter filter({known.kind, known.radius});
        const SampleSums sums = sample_sums(filter);
        EXPECT_NEAR(filter.integral(), known.integral, 6e-7) << label(filter);
        EXPECT_NEAR(sums.least.sum, known.least, 1e-7) << label(filter);
        EXPECT_NEAR(sums.greatest.sum, known.greatest, 1e-7) << label(filter);
        EXPECT_NEAR(sums.ripple, known.ripple, 2e-6) << label(filter);
    }
}

/// What made the misprint of the cone's minimum: it is what the corner of the cell gives.
TEST(SampleSum, the_cone_is_least_beside_the_corner) {
    const Filter cone({FilterKind::cone, 1.5});
    EXPECT_NEAR(sample_sum(cone, 0, 0), 0.8974, 5e-5);
    const SampleSumAt least = sample_sums(cone).least;
    EXPECT_NEAR(least.x, 0.06459, 1e-5);
    EXPECT_NEAR(least.y, 0.06459, 1e-5);
}

TEST(SampleSum, no_place_is_beyond_the_extremes) {
    for (const PrintedSampleSums& row : printed_sample_sums()) {
        const Filter filter({row.kind, row.radius});
        const SampleSums sums = sample_sums(filter);
        for (double x = 0; x <= 1; x += 1.0 / 173) {
            for (double y = 0; y <= 1; y += 1.0 / 173) {
                const double sum = sample_sum(filter, x, y);
                ASSERT_GE(sum, sums.least.sum - 1e-7) << label(filter) << ' ' << x << ' ' << y;
                ASSERT_LE(sum, sums.greatest.sum + 1e-7) << label(filter) << ' ' << x << ' ' << y;
            }
        }
        EXPECT_NEAR(sample_sum(filter, sums.least.x, sums.least.y), sums.least.sum, 1e-12);
        EXPECT_NEAR(sample_sum(filter, sums.greatest.x, sums.greatest.y), sums.greatest.sum, 1e-12);
    }
}

/// By the midpoint rule, to which the steps of box and gaussian matter.
TEST(SampleSum, the_mean_over_a_cell_is_one) {
    constexpr int steps = 200;
    for (const Filter& filter : filter_tests::all_filters()) {
        double mean = 0;
        for (int i = 0; i < steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                mean += sample_sum(filter, (i + 0.5) / steps, (j + 0.5) / steps) / (steps * steps);
            }
        }
        EXPECT_NEAR(mean, 1, 1e-2) << label(filter);
    }
}

/// Both are partitions of unity: what they lose in one pixel they give to the next.
TEST(SampleSum, boxes_and_mitchell_have_no_ripple) {
    for (const FilterSettings& settings : {FilterSettings{FilterKind::box, 0.5},
                                           {FilterKind::box, 1.5},
                                           {FilterKind::mitchell, 2}}) {
        const SampleSums sums = sample_sums(Filter(settings));
        EXPECT_NEAR(sums.least.sum, 1, 1e-14);
        EXPECT_NEAR(sums.greatest.sum, 1, 1e-14);
        EXPECT_NEAR(sums.ripple, 0, 1e-14);
    }
}

}  // namespace
}  // namespace rayshoot
