#include "tracer/filter/filter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracer/filter/filters.h"
#include "tracer/filter/shape.h"
#include "tracer/random.h"

namespace rayshoot {
namespace {

using filter_tests::all_filters;
using filter_tests::integral;
using filter_tests::label;
using filter_tests::over_support;
using std::numbers::pi;

TEST(Filter, integral_agrees_with_quadrature) {
    for (const Filter& filter : all_filters()) {
        const double sum = over_support(filter, filter);
        EXPECT_NEAR(filter.integral() / sum, 1, 1e-13) << label(filter);
    }
}

TEST(Filter, weights_follow_the_published_formulas) {
    const double r = 0.7, radius = 1.7;
    const auto at = [&](FilterKind kind) { return Filter({kind, radius})(0, r); };
    EXPECT_EQ(at(FilterKind::box), 1);
    EXPECT_NEAR(at(FilterKind::cone), 1 - r / radius, 1e-15);
    EXPECT_NEAR(at(FilterKind::raised_cosine), 0.5 + 0.5 * std::cos(pi * r / radius), 1e-15);
    EXPECT_NEAR(at(FilterKind::gaussian), std::exp(-r * r / (2 * radius * radius / 9)), 1e-15);
    const double x = pi * r / radius;  // Harris 1978, minimum 4-term, with its middle at 0
    EXPECT_NEAR(
        at(FilterKind::blackman_harris),
        0.35875 + 0.48829 * std::cos(x) + 0.14128 * std::cos(2 * x) + 0.01168 * std::cos(3 * x),
        1e-15);
}

/// Mitchell & Netravali 1988, with any B and C.
double mitchell(double x, double b, double c) {
    x = std::abs(x);
    if (x >= 2) return 0;
    if (x < 1) {
        return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + 6 - 2 * b) / 6;
    }
    return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + 8 * b +
            24 * c) /
           6;
}

TEST(Filter, mitchell_is_that_of_a_third_and_a_third) {
    const Filter filter({FilterKind::mitchell, 2});
    for (double x = -2.25; x <= 2.25; x += 0.03125) {
        const double expected = mitchell(x, 1.0 / 3, 1.0 / 3) * mitchell(0.4, 1.0 / 3, 1.0 / 3);
        EXPECT_NEAR(filter(x, 0.4), expected, 1e-15) << x;
    }
    EXPECT_NEAR(filter.integral(), 1, 1e-15);
}

TEST(Filter, only_mitchell_has_negative_lobes) {
    for (const Filter& filter : all_filters()) {
        double least = 0;
        const double step = filter.reach() / 64;
        for (int i = -64; i < 64; ++i) {
            for (int j = -64; j < 64; ++j) least = std::min(least, filter(i * step, j * step));
        }
        EXPECT_EQ(least < 0, filter.negative_lobes()) << label(filter);
        EXPECT_EQ(filter.negative_lobes(), filter.settings().kind == FilterKind::mitchell);
    }
}

TEST(Filter, nothing_lies_beyond_its_reach) {
    for (const Filter& filter : all_filters()) {
        const double reach = filter.reach();
        EXPECT_EQ(filter(reach, 0), 0) << label(filter);
        EXPECT_EQ(filter(0, reach), 0) << label(filter);
        EXPECT_EQ(filter(-1.001 * reach, 0.1), 0) << label(filter);
        if (!filter.separable()) {
            EXPECT_EQ(filter(0.71 * reach, 0.71 * reach), 0) << label(filter);
        }
    }
}

/// A place on the edge of two pixels is in one of them.
TEST(Filter, boxes_tile_the_plane) {
    const Filter box;
    EXPECT_EQ(box(-0.5, 0.1) + box(0.5, 0.1), 1);
    EXPECT_EQ(box(-0.5, -0.5) + box(0.5, -0.5) + box(-0.5, 0.5) + box(0.5, 0.5), 1);
}

TEST(Filter, names_are_read_back) {
    for (const FilterKind kind : filter_tests::all_kinds) EXPECT_EQ(filter_kind(name(kind)), kind);
    EXPECT_EQ(filter_kind("hamming"), FilterKind::raised_cosine);
    EXPECT_THROW(filter_kind("sinc"), std::invalid_argument);
}

TEST(Filter, radii_out_of_range_are_refused) {
    for (const double radius : {0.0, -1.0, 0.49, 16.1, std::nan("")}) {
        EXPECT_THROW(Filter({FilterKind::cone, radius}), std::invalid_argument) << radius;
    }
}

/// Pairs from corner to corner, the least and greatest numbers among them.
std::vector<float> numbers() {
    std::vector<float> all{0,    0x1p-24f,     0x1p-20f,    0.5f - 0x1p-24f,
                           0.5f, 1 - 0x1p-20f, 1 - 0x1p-24f};
    for (int i = 1; i < 1000; ++i) all.push_back(static_cast<float>(i) / 1000);
    return all;
}

/// The share of |w| within the radius, or to the left of x, is u: for discs and for squares.
TEST(Filter, importance_inverts_the_distribution) {
    for (const Filter& filter : all_filters()) {
        const double radius = filter.settings().radius;
        const bool square = filter.separable();
        const auto density = [&](double s) {
            return std::abs(filter.profile(s)) * (square ? 1 : s);
        };
        const double from = square ? -radius : 0;
        const double whole = integral(from, radius, radius, density);
        for (const float u : numbers()) {
            const double s = filter.importance({u, 0}).x;  // azimuth 0 is the x axis
            const double share = integral(from, s, radius, density) / whole;
            ASSERT_NEAR(share, u, 1e-12) << label(filter) << ", u = " << u;
        }
    }
}

/// Four steps of Newton's method are enough for every number in [0, 1].
TEST(Filter, raised_cosine_inverts_to_the_last_digits) {
    for (int i = 0; i <= 100000; ++i) {
        const double u = i / 100000.0;
        const double s = shape::quantile(FilterKind::raised_cosine, u);
        ASSERT_NEAR(shape::cumulative(FilterKind::raised_cosine, s), u, 4e-15);
    }
}

TEST(Filter, uniform_offsets_divide_the_area) {
    for (const Filter& filter : all_filters()) {
        const double radius = filter.settings().radius;
        for (const float u : numbers()) {
            const Filter::Offset offset = filter.uniform({u, 0.25f});
            if (filter.separable()) {
                EXPECT_NEAR(offset.x, radius * (2.0 * u - 1), 1e-15 * radius);
                EXPECT_NEAR(offset.y, -radius / 2, 1e-15 * radius);
            } else {
                EXPECT_NEAR(offset.x, 0, 1e-15 * radius);
                EXPECT_NEAR(offset.y * offset.y / (radius * radius), u, 1e-15);
            }
        }
    }
}

/// The mean over random pairs of weight * light is the filtered light, here of a quadratic one.
/// Null hypothesis: it is; a normal mean is off by more than 4.5 standard errors once in 10^5
/// tests.
TEST(Filter, weights_of_offsets_are_unbiased) {
    constexpr int count = 200000;
    const auto light = [](double x, double y) { return 1 + 0.5 * x * x + 0.25 * x * y + y * y; };
    const auto expect_mean = [&](double wanted, auto&& offset, const std::string& what) {
        double sum = 0, squares = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const RandomSequence random(5, 0, i);
            const Filter::Offset at = offset({random.number(0), random.number(1)});
            const double value = at.weight * light(at.x, at.y);
            sum += value;
            squares += value * value;
        }
        const double mean = sum / count;
        const double error = std::sqrt((squares / count - mean * mean) / count);
        EXPECT_NEAR(mean, wanted, 4.5 * error) << what;
        EXPECT_LT(error, 0.01 * wanted) << what << ": tells nothing";
    };
    for (const Filter& filter : all_filters()) {
        const auto weighted = [&](double x, double y) { return filter(x, y) * light(x, y); };
        const double filtered = over_support(filter, weighted) / filter.integral();
        expect_mean(
            filtered, [&](Pair u) { return filter.importance(u); }, label(filter));
        expect_mean(
            filtered, [&](Pair u) { return filter.uniform(u); }, label(filter));
    }
}

}  // namespace
}  // namespace rayshoot
