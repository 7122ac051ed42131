#include "tracer/film/adaptive.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>

#include <cmath>
#include <numbers>

#include "tracer/random.h"

namespace rayshoot {
namespace {

TEST(SampleStatistics, mean_and_variance_are_those_of_all_samples) {
    constexpr double base = 1e4;  // differences of squares would lose half of the digits
    SampleStatistics statistics;
    double sum = 0, squares = 0;
    constexpr int count = 1000;
    for (int i = 0; i < count; ++i) {
        const double deviation = (i * 37) % 101 / 64.0;  // a float, and exact beside the base
        statistics.add(vec3(static_cast<float>(base + deviation)));
        sum += deviation;
        squares += deviation * deviation;
    }
    const double mean = sum / count;
    EXPECT_EQ(statistics.count(), count);
    EXPECT_NEAR(statistics.mean(), base + mean, 1e-9);
    EXPECT_NEAR(statistics.variance(), (squares - count * mean * mean) / (count - 1), 1e-9);
}

TEST(SampleStatistics, luminance_is_what_counts) {
    SampleStatistics green, blue;
    green.add({0, 1, 0});
    blue.add({0, 0, 1});
    EXPECT_NEAR(green.mean(), 0.7152, 1e-7);
    EXPECT_NEAR(blue.mean(), 0.0722, 1e-7);
    EXPECT_EQ(green.variance(), 0);
}

using Numbers = RandomSequence;
/// A sample's radiance from its random numbers.
using Light = double (*)(const Numbers& random);

struct Pixel {
    int traced = 0, kept = 0;
    double mean = 0;
};

/// As a renderer does it.
Pixel sampled(const AdaptiveSampling& rule, Light light, std::uint32_t pixel) {
    Pixel result;
    SampleStatistics seen;
    double sum = 0;
    for (int round = 0; const int count = rule.next(round, seen); ++round) {
        for (int i = 0; i < count; ++i) {
            const double value =
                light(Numbers(11, pixel, static_cast<std::uint32_t>(result.traced++)));
            seen.add(vec3(static_cast<float>(value)));
            if (!rule.keeps(round)) continue;
            sum += value;
            ++result.kept;
        }
    }
    result.mean = sum / result.kept;
    return result;
}

double normal(const Numbers& random) {
    return std::sqrt(-2 * std::log1p(-double{random.number(0)})) *
           std::cos(2 * std::numbers::pi * random.number(1));
}

TEST(AdaptiveSampling, stops_after_the_first_round_where_samples_agree) {
    const AdaptiveSampling rule({.least = 8, .round = 4, .most = 64});
    EXPECT_EQ(sampled(
                  rule, [](const Numbers&) { return 0.25; }, 0)
                  .traced,
              8);
}

TEST(AdaptiveSampling, takes_no_more_than_the_most) {
    const AdaptiveSampling rule({.least = 8, .round = 5, .most = 64});
    const auto noise = [](const Numbers& random) { return double{random.number(0)}; };
    for (std::uint32_t pixel = 0; pixel < 100; ++pixel) {
        EXPECT_EQ(sampled(rule, noise, pixel).traced, 64);
    }
}

double mean_count(const AdaptiveSampling& rule, Light light) {
    double sum = 0;
    for (std::uint32_t pixel = 0; pixel < 500; ++pixel) sum += sampled(rule, light, pixel).traced;
    return sum / 500;
}

TEST(AdaptiveSampling, noise_takes_samples_and_shows_most_in_the_dark) {
    const AdaptiveSampling rule({.least = 8, .round = 8, .most = 1024});
    const double calm = mean_count(rule, [](const Numbers& n) { return 0.5 + 0.01 * normal(n); });
    const double wild = mean_count(rule, [](const Numbers& n) { return 0.5 + 0.05 * normal(n); });
    const double dark = mean_count(rule, [](const Numbers& n) { return 0.1 + 0.05 * normal(n); });
    EXPECT_LT(2 * calm, wild);
    EXPECT_LT(2 * wild, dark);
}

/// Normal samples whose true standard error after the first round is the tolerance: with the chance
/// `level` the round is taken to be enough. 20000 pixels tell it to 0.0015; five times that and the
/// little that the mean's own error does to the slope of the display curve are allowed.
TEST(AdaptiveSampling, stops_too_soon_with_the_chance_that_is_set) {
    constexpr double sigma = 0.01, mean = 0.5;
    const double slope = 1.055 / 2.4 * std::pow(mean, 1 / 2.4 - 1);
    const AdaptiveSampling rule(
        {.least = 16, .round = 16, .most = 32, .tolerance = sigma / 4 * slope, .level = 0.05});
    int stopped = 0;
    for (std::uint32_t pixel = 0; pixel < 20000; ++pixel) {
        stopped += sampled(
                       rule, [](const Numbers& n) { return mean + sigma * normal(n); }, pixel)
                       .traced == 16;
    }
    EXPECT_NEAR(stopped / 20000.0, 0.05, 0.008);
}

/// And of normal samples of any spread the error of pixels that were stopped is about what it
/// should be at most.
TEST(AdaptiveSampling, errors_meet_the_tolerance) {
    constexpr double mean = 0.5;
    const double slope = 1.055 / 2.4 * std::pow(mean, 1 / 2.4 - 1);
    const AdaptiveSampling rule({.least = 16, .round = 4, .most = 4096, .tolerance = 0.005});
    double squares = 0;
    for (std::uint32_t pixel = 0; pixel < 1000; ++pixel) {
        const double error =
            sampled(
                rule, [](const Numbers& n) { return mean + 0.1 * normal(n); }, pixel)
                .mean -
            mean;
        squares += slope * slope * error * error / 1000;
    }
    EXPECT_LT(std::sqrt(squares), 0.005);
    EXPECT_GT(std::sqrt(squares), 0.0025);  // and it is not met by waste
}

constexpr double chance = 0.02;  ///< of a sample that meets a small bright thing
double rare(const Numbers& random) {
    return random.number(0) < static_cast<float>(chance) ? 1.0 : 0.0;
}

SampleStatistics statistics(int events, int count) {
    SampleStatistics result;
    for (int i = 0; i < count; ++i) result.add(vec3(i < events ? 1.0f : 0.0f));
    return result;
}

/// The exact expectation of a sequentially sampled pixel of rare events: over all numbers of events
/// that may have been seen when it stops.
double expectation(const AdaptiveSampling& rule) {
    double mean = 0;
    int count = rule.next(0, {});
    std::vector<double> probability{1};  // by the number of events
    for (int round = 1, more = count; more > 0; ++round) {
        const boost::math::binomial events(more, chance);
        std::vector<double> after(static_cast<std::size_t>(count) + 1);
        for (std::size_t before = 0; before < probability.size(); ++before) {
            for (int k = 0; k <= more; ++k) {
                after[before + static_cast<std::size_t>(k)] += probability[before] * pdf(events, k);
            }
        }
        more = 0;
        for (std::size_t k = 0; k < after.size(); ++k) {
            const int next = rule.next(round, statistics(static_cast<int>(k), count));
            if (next == 0) {
                mean += after[k] * static_cast<double>(k) / count;
                after[k] = 0;
            } else {
                more = next;
            }
        }
        probability = after;
        count += more;
    }
    return mean;
}

/// Mean of the estimates of many pixels, and its standard error.
std::pair<double, double> estimated(const AdaptiveSampling& rule) {
    constexpr std::uint32_t pixels = 20000;
    double sum = 0, squares = 0;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
        const double mean = sampled(rule, rare, pixel).mean;
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / pixels;
    return {mean, std::sqrt((squares / pixels - mean * mean) / pixels)};
}

constexpr double sure = 4.5;  ///< standard errors; a normal mean is farther off once in 10^5

/// A pixel that has met no bright sample in the first round takes itself for black: the mean over
/// pixels is too small, by two thirds here.
TEST(AdaptiveSampling, is_biased_against_rare_events) {
    const AdaptiveSampling rule({.least = 16, .round = 16, .most = 256});
    const double expected = expectation(rule);
    // Nearly all others go on to the end: what is lost is what 240 samples would have brought.
    const double missed = std::pow(1 - chance, 16);
    EXPECT_NEAR(expected / chance, 1 - missed * 240 / 256, 1e-3);
    EXPECT_LT(expected, 0.35 * chance);
    const auto [mean, error] = estimated(rule);
    EXPECT_NEAR(mean, expected, sure * error);
    EXPECT_LT(mean, chance - 10 * error);
}

/// With a tolerance that rounds in the middle may meet, too.
TEST(AdaptiveSampling, bias_is_what_is_computed_for_a_coarse_tolerance) {
    const AdaptiveSampling rule({.least = 16, .round = 16, .most = 256, .tolerance = 0.1});
    const auto [mean, error] = estimated(rule);
    EXPECT_NEAR(mean, expectation(rule), sure * error);
}

TEST(AdaptiveSampling, more_samples_at_first_make_the_bias_small) {
    const AdaptiveSampling rule({.least = 256, .round = 64, .most = 1024});
    EXPECT_NEAR(expectation(rule) / chance, 1, 0.006);
}

TEST(AdaptiveSampling, a_fixed_number_is_not_biased) {
    const AdaptiveSampling rule({.least = 64, .most = 64});
    EXPECT_NEAR(expectation(rule), chance, 1e-12);
    const auto [mean, error] = estimated(rule);
    EXPECT_NEAR(mean, chance, sure * error);
}

/// Though pixels still have different numbers of samples.
TEST(AdaptiveSampling, two_passes_are_not_biased) {
    const AdaptiveSampling rule({.adaptation = Adaptation::two_pass, .least = 16, .most = 256});
    const auto [mean, error] = estimated(rule);
    EXPECT_NEAR(mean, chance, sure * error);
    EXPECT_EQ(rule.next(1, statistics(0, 16)), 16);
    EXPECT_EQ(rule.next(1, statistics(4, 16)), 256);
    EXPECT_EQ(rule.next(2, statistics(4, 272)), 0);
    EXPECT_FALSE(rule.keeps(0));
    EXPECT_TRUE(rule.keeps(1));
}

TEST(AdaptiveSampling, settings_out_of_range_are_refused) {
    for (const AdaptiveSettings& settings :
         {AdaptiveSettings{.least = 1}, AdaptiveSettings{.round = 0}, AdaptiveSettings{.most = 15},
          AdaptiveSettings{.most = 1 << 20}, AdaptiveSettings{.tolerance = 0},
          AdaptiveSettings{.tolerance = std::nan("")}, AdaptiveSettings{.level = 0},
          AdaptiveSettings{.level = 1}}) {
        EXPECT_THROW(AdaptiveSampling{settings}, std::invalid_argument);
    }
}

}  // namespace
}  // namespace rayshoot
