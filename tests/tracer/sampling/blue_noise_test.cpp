#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tests/tracer/sampling/kinds.h"
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

constexpr int edge = 128;  // of an image of errors, pixels
constexpr std::uint32_t images = 8;

using Image = std::vector<double>;

/// Of each pixel: the mean over its samples of an integrand that is neither symmetric nor
/// separable, less the integral. The image spans four tiles, and begins in the middle of quads.
Image errors(const Sampler& sampler, std::uint32_t place) {
    const double integral = (std::exp(2.0) - 1) / 2 * (1 - std::exp(-1.0)) + 0.25;
    Image image;
    for (int i = 0; i < edge * edge; ++i) {
        const Pixel pixel{static_cast<std::int16_t>(i % edge + 197),
                          static_cast<std::int16_t>(i / edge - 59)};
        double sum = 0;
        for (const std::uint32_t s : samples(sampler.settings().spp)) {
            const auto [u, v] = sampler.pair(pixel, s, {Use::light, place});
            sum += std::exp(2.0 * u - v) + u * v;
        }
        image.push_back(sum / sampler.settings().spp - integral);
    }
    return image;
}

double at(const Image& image, int x, int y) {
    return image[static_cast<std::size_t>(y * edge + x)];
}

/// |Fourier coefficient|^2 of the wave with (kx, ky) periods in the image.
double wave_energy(const Image& image, int kx, int ky) {
    std::complex<double> sum = 0;
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            sum += std::polar(at(image, x, y), 2 * std::numbers::pi * (kx * x + ky * y) / edge);
        }
    }
    return std::norm(sum);
}

struct Noise {
    double energy = 0;       ///< mean square, per pixel
    double slow_energy = 0;  ///< mean of waves of 16 pixels and more, relative to that of all waves
    double neighbours = 0;   ///< correlation with the right and the lower one
};

Noise noise(const SamplerSettings& settings) {
    const Sampler sampler(settings);
    constexpr int highest = edge / 16;
    double squares = 0, products = 0, slow = 0;
    int waves = 0;
    for (std::uint32_t place = 1; place <= images; ++place) {
        const Image image = errors(sampler, place);
        for (int y = 0; y + 1 < edge; ++y) {
            for (int x = 0; x + 1 < edge; ++x) {
                const double here = at(image, x, y);
                squares += here * here;
                products += here * (at(image, x + 1, y) + at(image, x, y + 1)) / 2;
            }
        }
        for (int kx = 0; kx <= highest; ++kx) {
            for (int ky = kx == 0 ? 1 : -highest; ky <= highest; ++ky, ++waves) {
                slow += wave_energy(image, kx, ky);
            }
        }
    }
    const double energy = squares / (images * (edge - 1) * (edge - 1));
    return {energy, slow / waves / (edge * edge) / energy, products / squares};
}

/// Errors of neighbours cancel: so the noise is not less, but finer.
TEST(BlueNoise, errors_have_little_energy_at_low_frequencies) {
    for (const int spp : {1, 4, 16}) {
        const Noise white = noise({SamplerKind::sobol, spp});
        const Noise blue = noise({SamplerKind::sobol, spp, true});
        // Over 1000 waves, and 250000 neighbours: a deviation of 0.03, and of 0.002.
        EXPECT_NEAR(white.slow_energy, 1, 0.12) << spp;
        EXPECT_NEAR(white.neighbours, 0, 0.01) << spp;
        EXPECT_LT(blue.slow_energy, 0.1) << spp;
        EXPECT_LT(blue.neighbours, -0.12) << spp;
        // A tile has one scrambling, on which its energy depends: by half of it, over 32 tiles.
        EXPECT_NEAR(blue.energy / white.energy, 1, 0.3) << spp;
    }
}

}  // namespace
}  // namespace rayshoot
