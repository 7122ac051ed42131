#include "tracer/filter/splat_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "tests/tracer/filter/filters.h"
#include "tracer/filter/sample_sum.h"
#include "tracer/random.h"

namespace rayshoot {
namespace {

using filter_tests::all_filters;
using filter_tests::label;

/// Positions in the cell: its corners and middle, and random ones.
std::vector<Pair> positions() {
    std::vector<Pair> all{{0, 0}, {0.5f, 0.5f}, {0, 0.5f}, {1 - 0x1p-24f, 1 - 0x1p-24f}, {0.2f, 0}};
    for (std::uint32_t i = 0; i < 500; ++i) {
        const RandomSequence random(3, 0, i);
        all.push_back({random.number(0), random.number(1)});
    }
    return all;
}

/// The weights around a sample at (x, y), by the pixel's offset from the sample's cell.
class Weights {
public:
    Weights(const SplatFootprint& footprint, Pair at)
        : edge_(footprint.edge()), weights_(footprint.room()) {
        corner_ = footprint.weigh(at.u, at.v, weights_);
    }
    double at(int column, int row) const {
        const int i = column - corner_.left, j = row - corner_.top;
        if (i < 0 || i >= edge_ || j < 0 || j >= edge_) return 0;
        return weights_[static_cast<std::size_t>(j * edge_ + i)];
    }
    double sum() const {
        return std::accumulate(weights_.begin(), weights_.begin() + edge_ * edge_, 0.0);
    }

private:
    int edge_;
    SplatFootprint::Corner corner_;
    std::vector<float> weights_;
};

/// Of every pixel in reach and beyond, whether it is covered or not.
TEST(SplatFootprint, weights_are_the_filter_s_within_the_stated_error) {
    for (const Filter& filter : all_filters()) {
        const SplatFootprint footprint(filter);
        const int far = footprint.border() + 1;
        for (const Pair& at : positions()) {
            const Weights weights(footprint, at);
            for (int row = -far; row <= far; ++row) {
                for (int column = -far; column <= far; ++column) {
                    const double weight = weights.at(column, row) * filter.integral();
                    const double exact = filter(at.u - 0.5 - column, at.v - 0.5 - row);
                    ASSERT_NEAR(weight, exact, SplatFootprint::largest_error)
                        << label(filter) << " at " << at.u << ' ' << at.v;
                }
            }
        }
    }
}

/// Beyond the border weights are not only small, but 0.
TEST(SplatFootprint, lies_within_the_border) {
    for (const Filter& filter : all_filters()) {
        const SplatFootprint footprint(filter);
        const int far = footprint.border() + 1;
        for (const Pair& at : positions()) {
            const Weights weights(footprint, at);
            for (int i = -far; i <= far; ++i) {
                EXPECT_EQ(weights.at(-far, i), 0) << label(filter);
                EXPECT_EQ(weights.at(far, i), 0) << label(filter);
                EXPECT_EQ(weights.at(i, -far), 0) << label(filter);
                EXPECT_EQ(weights.at(i, far), 0) << label(filter);
            }
        }
    }
}

/// Only mitchell's: a quotient of sums is between what is summed.
TEST(SplatFootprint, weights_are_not_negative) {
    for (const Filter& filter : all_filters()) {
        if (filter.negative_lobes()) continue;
        const SplatFootprint footprint(filter);
        const int far = footprint.border();
        for (const Pair& at : positions()) {
            const Weights weights(footprint, at);
            for (int row = -far; row <= far; ++row) {
                for (int column = -far; column <= far; ++column) {
                    EXPECT_GE(weights.at(column, row), 0) << label(filter);
                }
            }
        }
    }
}

TEST(SplatFootprint, border_is_the_reach_beyond_a_pixel_s_middle) {
    const auto border = [](double radius) {
        return SplatFootprint(Filter({FilterKind::box, radius})).border();
    };
    EXPECT_EQ(border(0.5), 0);
    EXPECT_EQ(border(0.51), 1);
    EXPECT_EQ(border(1.5), 1);
    EXPECT_EQ(border(1.7), 2);
    EXPECT_EQ(border(2), 2);
    EXPECT_EQ(border(16), 16);
}

/// A sample of a box of one pixel counts in its own pixel alone, with exactly 1.
TEST(SplatFootprint, the_smallest_box_is_its_own_pixel) {
    const SplatFootprint footprint{Filter()};
    for (const Pair& at : positions()) {
        const Weights weights(footprint, at);
        EXPECT_EQ(weights.at(0, 0), 1.0);
        EXPECT_EQ(weights.sum(), 1.0);
    }
}

/// What is given to all pixels is the sum that the textbook tabulates.
TEST(SplatFootprint, weights_add_up_to_the_sample_sum) {
    for (const PrintedSampleSums& row : printed_sample_sums()) {
        const Filter filter({row.kind, row.radius});
        const SplatFootprint footprint(filter);
        for (const Pair& at : positions()) {
            EXPECT_NEAR(Weights(footprint, at).sum(), sample_sum(filter, at.u, at.v), 1e-5)
                << label(filter);
        }
    }
}

}  // namespace
}  // namespace rayshoot
