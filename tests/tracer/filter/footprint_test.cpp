#include "tracer/filter/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

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

/// Of every pixel in reach and beyond, whether it is covered or not.
TEST(Footprint, weights_are_the_filter_s_within_the_stated_error) {
    for (const Filter& filter : all_filters()) {
        const Footprint footprint(filter);
        std::vector<float> weights(footprint.largest());
        const int far = footprint.border() + 1;
        for (const Pair& at : positions()) {
            const Cover cover = footprint.weigh(at.u, at.v, weights);
            ASSERT_LE(static_cast<std::size_t>(cover.columns * cover.rows), footprint.largest());
            for (int row = -far; row <= far; ++row) {
                for (int column = -far; column <= far; ++column) {
                    const int i = column - cover.left, j = row - cover.top;
                    const bool covered = i >= 0 && i < cover.columns && j >= 0 && j < cover.rows;
                    const double weight =
                        covered ? weights[static_cast<std::size_t>(j * cover.columns + i)] : 0;
                    const double exact = filter(at.u - 0.5 - column, at.v - 0.5 - row);
                    ASSERT_NEAR(weight * filter.integral(), exact, Footprint::table_error)
                        << label(filter) << " at " << at.u << ' ' << at.v;
                }
            }
        }
    }
}

TEST(Footprint, lies_within_the_border) {
    for (const Filter& filter : all_filters()) {
        const Footprint footprint(filter);
        std::vector<float> weights(footprint.largest());
        for (const Pair& at : positions()) {
            const Cover cover = footprint.weigh(at.u, at.v, weights);
            EXPECT_GE(cover.left, -footprint.border()) << label(filter);
            EXPECT_GE(cover.top, -footprint.border()) << label(filter);
            EXPECT_LE(cover.left + cover.columns, footprint.border() + 1) << label(filter);
            EXPECT_LE(cover.top + cover.rows, footprint.border() + 1) << label(filter);
        }
    }
}

TEST(Footprint, border_is_the_reach_beyond_a_pixel_s_middle) {
    const auto border = [](double radius) {
        return Footprint(Filter({FilterKind::box, radius})).border();
    };
    EXPECT_EQ(border(0.5), 0);
    EXPECT_EQ(border(0.51), 1);
    EXPECT_EQ(border(1.5), 1);
    EXPECT_EQ(border(1.7), 2);
    EXPECT_EQ(border(2), 2);
    EXPECT_EQ(border(16), 16);
}

/// A sample of a box of one pixel counts in its own pixel alone, with exactly 1.
TEST(Footprint, the_smallest_box_is_its_own_pixel) {
    const Footprint footprint{Filter()};
    std::vector<float> weights(footprint.largest());
    for (const Pair& at : positions()) {
        const Cover cover = footprint.weigh(at.u, at.v, weights);
        EXPECT_EQ(cover.left, 0);
        EXPECT_EQ(cover.top, 0);
        ASSERT_EQ(cover.columns * cover.rows, 1);
        EXPECT_EQ(weights[0], 1.0f);
    }
}

/// What is given to all pixels is the sum that the textbook tabulates.
TEST(Footprint, weights_add_up_to_the_sample_sum) {
    for (const PrintedSampleSums& row : printed_sample_sums()) {
        const Filter filter({row.kind, row.radius});
        const Footprint footprint(filter);
        std::vector<float> weights(footprint.largest());
        for (const Pair& at : positions()) {
            const Cover cover = footprint.weigh(at.u, at.v, weights);
            double sum = 0;
            for (int i = 0; i < cover.columns * cover.rows; ++i) {
                sum += weights[static_cast<std::size_t>(i)];
            }
            EXPECT_NEAR(sum, sample_sum(filter, at.u, at.v), 1e-5) << label(filter);
        }
    }
}

}  // namespace
}  // namespace rayshoot
