#include "bench/statistics/estimate.h"

#include "bench/statistics/random.h"
#include "bench/timing/steadiness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rayshoot {
namespace {

TEST(Median, of_an_even_number_is_the_mean_of_the_middle_two) {
    EXPECT_EQ(median(std::array{4.0, 1.0, 3.0, 2.0}), 2.5);
    EXPECT_EQ(median(std::array{3.0, 1.0, 2.0}), 2.0);
}

TEST(Median, of_no_samples_is_refused) {
    EXPECT_THROW(median({}), std::invalid_argument);
    EXPECT_THROW(bootstrap_median({}), std::invalid_argument);
}

TEST(Bootstrap, one_sample_has_an_interval_of_no_width) {
    const Estimate estimate = bootstrap_median(std::array{7.0});
    EXPECT_EQ(estimate.low, 7.0);
    EXPECT_EQ(estimate.high, 7.0);
}

TEST(Bootstrap, equal_samples_and_seeds_give_equal_intervals) {
    const std::array samples{5.0, 3.0, 9.0, 4.0, 8.0};
    const Estimate a = bootstrap_median(samples), b = bootstrap_median(samples);
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
}

double binomial_at_most(int most, int n, double p) {
    double sum = 0;
    for (int k = 0; k <= most; ++k) {
        sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)) *
               std::pow(p, k) * std::pow(1 - p, n - k);
    }
    return sum;
}

/// The rank r (from 1) of the bootstrap's quantile: for odd n the median of a resample is at most
/// the r-th smallest sample iff at least (n + 1) / 2 draws are, and each is with probability r / n.
int rank_of_quantile(int n, double p) {
    for (int r = 1; r <= n; ++r) {
        if (1 - binomial_at_most((n - 1) / 2, n, static_cast<double>(r) / n) >= p) return r;
    }
    return n;
}

TEST(Bootstrap, interval_of_an_odd_number_is_the_closed_form) {
    for (const int n : {5, 9, 15, 21, 51}) {
        std::vector<double> samples;
        for (int i = 1; i <= n; ++i) samples.push_back(i);
        const Estimate estimate = bootstrap_median(samples, 0.95, 20000);
        EXPECT_NEAR(estimate.low, rank_of_quantile(n, 0.025), 1) << n;
        EXPECT_NEAR(estimate.high, rank_of_quantile(n, 0.975), 1) << n;
    }
}

/// H0: the 95 % interval covers the true median in 90 to 98 % of cases (the percentile bootstrap of
/// a median is known to be a little off). 1000 cases of 15 samples; the share's standard error is
/// 0.7 %.
TEST(Bootstrap, interval_covers_the_true_median_about_as_often_as_it_says) {
    Sequence random(11);
    int covered = 0;
    constexpr int cases = 1000;
    for (int i = 0; i < cases; ++i) {
        std::vector<double> samples;
        for (int k = 0; k < 15; ++k) samples.push_back(-std::log1p(-random.unit()));
        const Estimate estimate = bootstrap_median(samples, 0.95, 500, random.next());
        covered += estimate.low <= std::log(2.0) && std::log(2.0) <= estimate.high;
    }
    EXPECT_GE(covered, 0.90 * cases);
    EXPECT_LE(covered, 0.98 * cases);
}

TEST(Bootstrap, overlapping_intervals_are_no_different) {
    EXPECT_TRUE((Estimate{2, 1, 3}).overlaps(Estimate{4, 3, 5}));
    EXPECT_FALSE((Estimate{2, 1, 3}).overlaps(Estimate{5, 4, 6}));
}

TEST(Spread, is_half_the_interquartile_range_over_the_median) {
    EXPECT_NEAR(relative_spread(std::array{1.0, 2.0, 3.0, 4.0, 5.0}), 1.0 / 3, 1e-12);
    EXPECT_EQ(relative_spread(std::array{2.0, 2.0, 2.0}), 0);
}

TEST(CentralRange, leaves_out_a_fortieth_at_either_end) {
    std::vector<double> samples(100, 10.0);
    samples[3] = 1000;  // a single disturbance
    EXPECT_EQ(central_range(samples), 0);
    for (int i = 0; i < 10; ++i) samples[static_cast<std::size_t>(i)] = 11;  // one that lasts
    EXPECT_NEAR(central_range(samples), 0.1, 1e-12);
}

TEST(CentralRange, of_few_samples_is_their_whole_range) {
    EXPECT_NEAR(central_range(std::array{1.0, 2.0, 3.0}), 1, 1e-12);
}

TEST(Steadiness, a_run_is_void_when_its_control_moved_further_than_allowed) {
    const std::array samples{1.0, 1.01, 1.04};
    EXPECT_EQ(steadiness(samples, 0.05).is_void(), false);
    EXPECT_EQ(steadiness(samples, 0.03).is_void(), true);
}

TEST(Steadiness, one_block_says_nothing) {
    EXPECT_FALSE(steadiness(std::array{1.0}, 0.05).moved.has_value());
    EXPECT_FALSE(steadiness(std::array{1.0}, 0.05).is_void().has_value());
}

TEST(GeometricMean, is_that_of_the_medians) {
    const std::vector<std::vector<double>> groups{{1, 2, 3}, {8, 8, 8}};
    const Estimate mean = bootstrap_geometric_mean(groups);
    EXPECT_NEAR(mean.median, 4, 1e-12);
    EXPECT_LT(mean.low, mean.median);
    EXPECT_GT(mean.high, mean.median);
}

TEST(GeometricMean, of_one_group_is_its_bootstrapped_median) {
    const std::vector<std::vector<double>> groups{{1, 2, 3, 4, 5, 6, 7}};
    const Estimate mean = bootstrap_geometric_mean(groups);
    const Estimate alone = bootstrap_median(groups.front());
    EXPECT_NEAR(mean.median, alone.median, 1e-12);
    EXPECT_NEAR(mean.low, alone.low, 1e-12);
    EXPECT_NEAR(mean.high, alone.high, 1e-12);
}

/// H0: the 95 % interval covers the true mean in 90 to 98 % of cases. 500 cases of 6 groups of 15
/// samples, log-uniform over a range of 2 round medians of 1; the share's standard error is 1 %.
TEST(GeometricMean, interval_covers_the_true_mean_about_as_often_as_it_says) {
    Sequence random(5);
    int covered = 0;
    constexpr int cases = 500;
    for (int i = 0; i < cases; ++i) {
        std::vector<std::vector<double>> groups(6, std::vector<double>(15));
        for (auto& group : groups) {
            for (double& value : group) value = std::exp2(random.unit() - 0.5);
        }
        const Estimate mean = bootstrap_geometric_mean(groups, 0.95, 400, random.next());
        covered += mean.low <= 1 && 1 <= mean.high;
    }
    EXPECT_GE(covered, 0.90 * cases);
    EXPECT_LE(covered, 0.98 * cases);
}

}  // namespace
}  // namespace rayshoot
