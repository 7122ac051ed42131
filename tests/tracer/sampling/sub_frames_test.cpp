#include "tracer/sampling/sub_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/tracer/sampling/chi_squared.h"
#include "tracer/camera.h"
#include "tracer/random.h"
#include "tracer/sampling/permutation.h"
#include "tracer/sampling/sampler.h"

namespace rayshoot {
namespace {

using Times = std::vector<std::uint16_t>;

/// |Correlation| of time with the column (`by` = across) or with the row, from its definition.
double correlation(const Times& times, std::size_t across, bool with_row) {
    double sx = 0, st = 0, sxx = 0, stt = 0, sxt = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto x = static_cast<double>(with_row ? i / across : i % across);
        const double t = times[i];
        sx += x, st += t, sxx += x * x, stt += t * t, sxt += x * t;
    }
    const auto n = static_cast<double>(times.size());
    const double squares = (sxx - sx * sx / n) * (stt - st * st / n);
    return squares > 0 ? std::abs(sxt - sx * st / n) / std::sqrt(squares) : 0;
}

double largest(const Times& times, std::size_t across) {
    return std::max(correlation(times, across, false), correlation(times, across, true));
}

Times of_key(const SubFrames& frames, std::size_t count, std::uint64_t key) {
    Times times(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        times[i] = static_cast<std::uint16_t>(frames.of(i, key));
    }
    return times;
}

TEST(SubFrames, each_key_permutes_them) {
    for (const auto& [across, down] : {std::pair(1, 1), {2, 1}, {2, 2}, {3, 2}, {4, 4}, {7, 1}}) {
        const SubFrames frames(across, down, 1);
        const auto count = static_cast<std::size_t>(across * down);
        for (std::uint64_t i = 0; i < 500; ++i) {
            const Times times = of_key(frames, count, scrambled(i));
            EXPECT_EQ(std::set(times.begin(), times.end()).size(), count);
            EXPECT_EQ(*std::ranges::max_element(times), count - 1);
        }
    }
}

/// The bound holds for whatever a key makes of a prototype. By chance it would be 1 / sqrt(n - 1),
/// for 4 x 4 strata 0.26, half of the time more.
TEST(SubFrames, hardly_correlate_with_place) {
    struct Case {
        int across, down;
        double bound;
    };
    // No 2 x 2 permutation has both rows and both columns alike; from 3 x 3 on they nearly can.
    for (const auto [across, down, bound] : {Case{2, 2, 0.4473},
                                             {3, 2, 0.1},
                                             {4, 3, 0.05},
                                             {3, 3, 0.02},
                                             {4, 4, 0.02},
                                             {5, 5, 0.02},
                                             {6, 6, 0.02},
                                             {8, 8, 0.02},
                                             {16, 16, 0.02}}) {
        const SubFrames frames(across, down, 1);
        const auto columns = static_cast<std::size_t>(across);
        for (std::uint64_t i = 0; i < 1000; ++i) {
            const Times times =
                of_key(frames, static_cast<std::size_t>(across * down), scrambled(i));
            ASSERT_LE(largest(times, columns), bound) << across << " x " << down;
        }
    }
}

TEST(SubFrames, the_largest_correlation_is_over_all_shifts) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        Times times(12);
        for (std::uint32_t i = 0; i < 12; ++i) {
            times[i] = static_cast<std::uint16_t>(permuted(i, 12, scrambled(seed)));
        }
        double expected = 0;
        for (std::size_t dx = 0; dx < 4; ++dx) {
            for (std::size_t dy = 0; dy < 3; ++dy) {
                Times shifted(12);
                for (std::size_t i = 0; i < 12; ++i) {
                    shifted[(i / 4 + dy) % 3 * 4 + (i + dx) % 4] = times[i];
                }
                expected = std::max(expected, largest(shifted, 4));
            }
        }
        EXPECT_NEAR(largest_correlation(times, 4, 3), expected, 1e-12);
        EXPECT_GT(expected, 0.1);
    }
}

TEST(SubFrames, prototypes_differ_and_no_line_is_monotone) {
    const SubFrames frames(4, 4, 1);
    std::set<Times> seen;
    for (int i = 0; i < SubFrames::prototypes; ++i) {
        const auto prototype = frames.prototype(i);
        seen.emplace(prototype.begin(), prototype.end());
        for (std::size_t line = 0; line < 4; ++line) {
            Times row, column;
            for (std::size_t j = 0; j < 4; ++j) {
                row.push_back(prototype[4 * line + j]);
                column.push_back(prototype[4 * j + line]);
            }
            for (const Times& times : {row, column}) {
                EXPECT_FALSE(std::ranges::is_sorted(times));
                EXPECT_FALSE(std::ranges::is_sorted(times, std::greater{}));
            }
        }
    }
    EXPECT_EQ(seen.size(), std::size_t{SubFrames::prototypes});
}

/// Null hypothesis: over keys a stratum is given each sub-frame equally often, 20000 keys.
TEST(SubFrames, each_stratum_is_given_each_one_equally_often) {
    for (const auto& [across, down] : {std::pair(2, 2), {3, 2}, {4, 4}, {5, 1}}) {
        const SubFrames frames(across, down, 1);
        const auto count = static_cast<std::uint32_t>(across * down);
        for (std::uint32_t stratum = 0; stratum < count; ++stratum) {
            Histogram histogram(count);
            for (std::uint64_t i = 0; i < 20000; ++i) {
                histogram.add(frames.of(stratum, scrambled(i)));
            }
            EXPECT_TRUE(histogram.uniform()) << stratum << " of " << count;
        }
    }
}

/// Root mean square over pixels of the correlation of time with x, 16 samples each.
double pixel_correlation(bool cook_time) {
    const Sampler sampler({SamplerKind::regular, 16, false, cook_time});
    double squares = 0;
    for (std::int16_t x = 0; x < 1000; ++x) {
        Times times;
        for (std::uint32_t s = 0; s < 16; ++s) {
            times.push_back(
                static_cast<std::uint16_t>(16 * sampler.number({x, 3}, s, {Use::time})));
        }
        squares += std::pow(correlation(times, 4, false), 2);
    }
    return std::sqrt(squares / 1000);
}

TEST(SubFrames, are_the_times_of_the_sampler) {
    EXPECT_LT(pixel_correlation(true), 0.01);
    EXPECT_NEAR(pixel_correlation(false), 1 / std::sqrt(15.0), 0.03);  // a random permutation's
}

}  // namespace
}  // namespace rayshoot
