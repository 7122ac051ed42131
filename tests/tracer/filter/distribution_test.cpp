#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>

#include <cmath>

#include "tests/tracer/filter/filters.h"
#include "tracer/random.h"

/// Samples of filters are distributed as they should be over the plane.
namespace rayshoot {
namespace {

using filter_tests::all_filters;
using filter_tests::label;

constexpr int cells = 16;  ///< along an axis of the support
constexpr std::uint32_t samples = 1 << 18;
/// Chance that a correct sampler fails, for each of the tests. Seeds are fixed, so verdicts are
/// too.
constexpr double level = 1e-5;

using Counts = std::vector<double>;

/// Expected counts of a density over the support, by the midpoint rule with so many points a cell
/// and axis that the steps at the edge of a disc cost less than the tests can tell.
template <class Density>
Counts expected(double radius, Density&& density) {
    constexpr int points = 100;
    constexpr double step = 2.0 / (cells * points);
    Counts counts(cells * cells);
    double whole = 0;
    for (int row = 0; row < cells * points; ++row) {
        for (int column = 0; column < cells * points; ++column) {
            const double value =
                density(radius * ((column + 0.5) * step - 1), radius * ((row + 0.5) * step - 1));
            counts[static_cast<std::size_t>(row / points * cells + column / points)] += value;
            whole += value;
        }
    }
    for (double& count : counts) count *= samples / whole;
    return counts;
}

template <class Sample>
Counts observed(double radius, std::uint32_t seed, Sample&& sample) {
    Counts counts(cells * cells);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const RandomSequence random(seed, 0, i);
        const Filter::Offset offset = sample({random.number(0), random.number(1)});
        const auto cell = [radius](double x) {
            return std::min(static_cast<int>((x / radius + 1) / 2 * cells), cells - 1);
        };
        ++counts[static_cast<std::size_t>(cell(offset.y) * cells + cell(offset.x))];
    }
    return counts;
}

/// Null hypothesis: `seen` is drawn from `wanted`. Cells with less than 10 expected samples, for
/// which chi^2 is no good approximation, are taken together.
void expect_agree(const Counts& seen, const Counts& wanted, const std::string& what) {
    double sum = 0, rare_seen = 0, rare_wanted = 0;
    int degrees = -1;
    const auto add = [&](double count, double mean) {
        sum += (count - mean) * (count - mean) / mean;
        ++degrees;
    };
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (wanted[i] >= 10) {
            add(seen[i], wanted[i]);
        } else {
            rare_seen += seen[i];
            rare_wanted += wanted[i];
        }
    }
    if (rare_wanted >= 10) {
        add(rare_seen, rare_wanted);
    } else {
        EXPECT_LE(rare_seen, 40) << what;  // a Poisson number of mean 10: chance 10^-12
    }
    const boost::math::chi_squared distribution(degrees);
    EXPECT_LT(sum, quantile(complement(distribution, level))) << what << ", degrees " << degrees;
}

TEST(FilterDistribution, importance_samples_follow_the_magnitude) {
    std::uint32_t seed = 1;
    for (const Filter& filter : all_filters()) {
        const double radius = filter.settings().radius;
        const auto wanted =
            expected(radius, [&](double x, double y) { return std::abs(filter(x, y)); });
        const auto seen =
            observed(radius, ++seed, [&](Pair pair) { return filter.importance(pair); });
        expect_agree(seen, wanted, label(filter));
    }
}

TEST(FilterDistribution, uniform_samples_are_uniform_over_the_support) {
    std::uint32_t seed = 100;
    for (const Filter& filter : all_filters()) {
        const double radius = filter.settings().radius;
        const bool square = filter.separable();
        const auto wanted = expected(radius, [&](double x, double y) {
            return square || x * x + y * y < radius * radius ? 1.0 : 0.0;
        });
        const auto seen = observed(radius, ++seed, [&](Pair pair) { return filter.uniform(pair); });
        expect_agree(seen, wanted, label(filter));
    }
}

/// So that the tests above mean something: the cone's samples do not pass for the raised cosine's.
TEST(FilterDistribution, another_filter_would_be_noticed) {
    const Filter cone({FilterKind::cone, 1.7}), cosine({FilterKind::raised_cosine, 1.7});
    const Counts wanted = expected(1.7, cosine);
    const Counts seen = observed(1.7, 7, [&](Pair pair) { return cone.importance(pair); });
    double sum = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (wanted[i] >= 10) sum += (seen[i] - wanted[i]) * (seen[i] - wanted[i]) / wanted[i];
    }
    EXPECT_GT(sum, 1000);
}

}  // namespace
}  // namespace rayshoot
