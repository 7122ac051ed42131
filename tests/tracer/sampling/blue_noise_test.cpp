#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tracer/camera.h"
#include "tracer/sampling/pixel_ranks.h"
#include "tracer/sampling/sampler.h"

namespace rayshoot {
namespace {

TEST(PixelRanks, each_quad_of_each_size_takes_consecutive_ranks) {
    const PixelRanks ranks(1);
    for (int edge = 1; edge <= PixelRanks::edge; edge *= 2) {
        const auto area = static_cast<std::uint32_t>(edge * edge);
        std::vector<bool> taken(std::size_t{PixelRanks::edge} * PixelRanks::edge / area);
        for (int y = 0; y < PixelRanks::edge; y += edge) {
            for (int x = 0; x < PixelRanks::edge; x += edge) {
                const std::uint32_t block = ranks(x, y) / area;
                EXPECT_FALSE(taken[block]);
                taken[block] = true;
                for (int i = 1; i < edge * edge; ++i) {
                    ASSERT_EQ(ranks(x + i % edge, y + i / edge) / area, block);
                }
            }
        }
    }
}

TEST(PixelRanks, repeat_in_each_tile_also_to_the_left) {
    const PixelRanks ranks(1);
    EXPECT_EQ(ranks(-1, -256), ranks(255, 0));
    EXPECT_EQ(ranks(300, 1000), ranks(44, 232));
}

TEST(PixelRanks, quads_are_ordered_each_in_a_way_of_its_own) {
    const PixelRanks ranks(1);
    std::vector<std::size_t> counts(24);
    for (int y = 0; y < PixelRanks::edge; y += 2) {
        for (int x = 0; x < PixelRanks::edge; x += 2) {
            std::vector<int> order{0, 1, 2, 3};
            std::ranges::sort(order, {}, [&](int i) { return ranks(x + i % 2, y + i / 2); });
            std::size_t number = 0;
            while (std::ranges::prev_permutation(order).found) ++number;
            ++counts[number];
        }
    }
    // 16384 / 24 = 683, and five standard deviations.
    for (const std::size_t count : counts) EXPECT_NEAR(static_cast<double>(count), 683, 130);
}

constexpr int edge = 128;  // of the image of errors, pixels

/// A pixel's error: the mean over its samples of an integrand that is neither symmetric nor
/// separable, less the integral. It spans four tiles, and begins in the middle of quads.
std::vector<double> errors(const Sampler& sampler) {
    std::vector<double> image;
    const double integral = (std::exp(2.0) - 1) / 2 * (1 - std::exp(-1.0)) + 0.25;
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            double sum = 0;
            for (int s = 0; s < sampler.settings().spp; ++s) {
                const Pixel pixel{static_cast<std::int16_t>(x + 197),
                                  static_cast<std::int16_t>(y - 59)};
                const auto [u, v] =
                    sampler.pair(pixel, static_cast<std::uint32_t>(s), {Use::light, 2});
                sum += std::exp(2.0 * u - v) + u * v;
            }
            image.push_back(sum / sampler.settings().spp - integral);
        }
    }
    return image;
}

double mean_square(const std::vector<double>& image) {
    double sum = 0;
    for (const double error : image) sum += error * error;
    return sum / static_cast<double>(image.size());
}

/// Mean energy of the waves of at least 8 pixels, in both directions, relative to that of all:
/// 1 for white noise.
double low_frequency_energy(const std::vector<double>& image) {
    constexpr int highest = edge / 8;
    double sum = 0;
    int waves = 0;
    for (int kx = 0; kx <= highest; ++kx) {
        std::vector<std::complex<double>> rows(edge);
        for (int i = 0; i < edge * edge; ++i) {
            const double phase = 2 * std::numbers::pi * kx * (i % edge) / edge;
            rows[static_cast<std::size_t>(i / edge)] +=
                std::polar(image[static_cast<std::size_t>(i)], phase);
        }
        for (int ky = -highest; ky <= highest; ++ky) {
            if (kx * kx + ky * ky > highest * highest || (kx == 0 && ky <= 0)) continue;
            std::complex<double> wave = 0;
            for (int y = 0; y < edge; ++y) {
                const double phase = 2 * std::numbers::pi * ky * y / edge;
                wave += rows[static_cast<std::size_t>(y)] * std::polar(1.0, phase);
            }
            sum += std::norm(wave);
            ++waves;
        }
    }
    return sum / waves / (edge * edge) / mean_square(image);
}

/// Correlation of a pixel's error with its right and lower neighbour's.
double neighbour_correlation(const std::vector<double>& image) {
    double sum = 0;
    int pairs = 0;
    for (int i = 0; i < edge * (edge - 1); ++i) {
        const auto at = static_cast<std::size_t>(i);
        sum += image[at] * image[at + edge];
        ++pairs;
        if (i % edge == edge - 1) continue;
        sum += image[at] * image[at + 1];
        ++pairs;
    }
    return sum / pairs / mean_square(image);
}

struct Case {
    int spp;
    double most_energy;  ///< at low frequencies
};

TEST(BlueNoise, errors_have_little_energy_at_low_frequencies) {
    for (const auto [spp, most_energy] : {Case{1, 0.1}, Case{4, 0.1}, Case{16, 0.1}}) {
        const auto white = errors(Sampler({SamplerKind::sobol, spp}));
        const auto blue = errors(Sampler({SamplerKind::sobol, spp, true}));
        // About 400 waves: a relative deviation of 1/20 for white noise.
        EXPECT_NEAR(low_frequency_energy(white), 1, 0.25) << spp;
        EXPECT_LT(low_frequency_energy(blue), most_energy) << spp;
        EXPECT_NEAR(neighbour_correlation(white), 0, 0.03) << spp;
        EXPECT_LT(neighbour_correlation(blue), -0.1) << spp;
        // The noise is not less, it is finer.
        EXPECT_NEAR(mean_square(blue) / mean_square(white), 1, 0.1) << spp;
        RecordProperty("energy", std::to_string(low_frequency_energy(blue)));
    }
}

}  // namespace
}  // namespace rayshoot
