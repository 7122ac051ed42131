#include "accel/core/catalogue.h"
#include "data/scenes.h"
#include "tracer/render.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

/// Our path tracer against an independent one, Mitsuba 3 (reference/README.md).
namespace rayshoot {
namespace {

constexpr int edge = 64, block = 8;  // pixels
constexpr int across = edge / block;
constexpr int channels = 3;
using Blocks = std::array<double, across * across * channels>;  ///< means

/// Sums over the pixels of each block of what `term` makes of a channel's value.
template <class Term>
Blocks sums(const Image& image, Term&& term) {
    Blocks blocks{};
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            for (int channel = 0; channel < channels; ++channel) {
                const int at = (y / block * across + x / block) * channels + channel;
                blocks[static_cast<std::size_t>(at)] += term(double{image.at(x, y)[channel]});
            }
        }
    }
    return blocks;
}

Blocks blocks_of(const Image& image) {
    return sums(image, [](double value) { return value / (block * block); });
}

/// Of one channel.
double mean_of(const Blocks& blocks, std::size_t channel) {
    double sum = 0;
    for (std::size_t i = channel; i < blocks.size(); i += channels) sum += blocks[i];
    return sum / (across * across);
}

/// Of independent values, and the standard error of their mean.
struct Mean {
    double value = 0, error = 0;
};

/// The reference: blocks, and the standard errors of its pixels, which are independent.
struct Reference {
    Blocks values = blocks_of(read_image("tests/tracer/reference/cornell_box.exr"));
    Blocks variances = sums(read_image("tests/tracer/reference/cornell_box_error.exr"),
                            [](double error) { return std::pow(error / (block * block), 2); });

    Mean of_block(std::size_t i) const { return {values[i], std::sqrt(variances[i])}; }
    Mean of_image(std::size_t channel) const {
        return {mean_of(values, channel), std::sqrt(mean_of(variances, channel)) / across};
    }
};

template <class ValueOf>
Mean mean_over(const std::vector<Blocks>& passes, ValueOf&& value_of) {
    const auto count = static_cast<double>(passes.size());
    Mean mean;
    for (const Blocks& pass : passes) mean.value += value_of(pass) / count;
    double squares = 0;
    for (const Blocks& pass : passes) squares += std::pow(value_of(pass) - mean.value, 2);
    mean.error = std::sqrt(squares / (count - 1) / count);
    return mean;
}

class CornellBox : public testing::Test {
protected:
    static std::vector<Blocks> rendered(const TransportSettings& transport, int spp, int passes) {
        const Scene scene = load_scene("data/gallery/cornell_box.nff");
        RenderSettings settings;
        settings.format = {edge, edge, spp, Raster::centres, 0};
        settings.transport = transport;
        const auto accel = build(built_in_catalogue(), "bvh8", build_input(scene, settings));
        std::vector<Blocks> result;
        for (int pass = 0; pass < passes; ++pass) {
            settings.format.seed = static_cast<std::uint32_t>(pass);
            result.push_back(blocks_of(render(scene, *accel, settings).image));
        }
        return result;
    }

    static Mean block_mean(const std::vector<Blocks>& passes, std::size_t i) {
        return mean_over(passes, [i](const Blocks& pass) { return pass[i]; });
    }
    static Mean image_mean(const std::vector<Blocks>& passes, std::size_t channel) {
        return mean_over(passes, [&](const Blocks& pass) { return mean_of(pass, channel); });
    }

    const Reference reference;
};

std::string place(std::size_t i) {
    return "block " + std::to_string(i / channels % across) + ", " +
           std::to_string(i / channels / across) + ", channel " + std::to_string(i % channels);
}

// Null hypothesis: each of 192 values has the reference's mean. Each is refused at a level of
// 0.001 / 192, so that right code fails once in a thousand choices of seeds.
constexpr int passes = 16;
constexpr double critical_t = 6.89;  // two-sided, of Student's t with passes - 1 degrees of freedom

TEST_F(CornellBox, by_paths_has_the_blocks_of_an_independent_renderer_within_noise) {
    const auto ours = rendered({.method = Method::path}, 64, passes);
    for (std::size_t i = 0; i < reference.values.size(); ++i) {
        const Mean mean = block_mean(ours, i), expected = reference.of_block(i);
        EXPECT_NEAR(mean.value, expected.value, critical_t * std::hypot(mean.error, expected.error))
            << place(i);
    }
}

TEST_F(CornellBox, by_paths_has_the_energy_of_an_independent_renderer_to_one_percent) {
    const auto ours = rendered({.method = Method::path}, 16, passes);
    for (std::size_t channel = 0; channel < channels; ++channel) {
        const Mean mean = image_mean(ours, channel), expected = reference.of_image(channel);
        EXPECT_LT(std::hypot(mean.error, expected.error), 0.003 * expected.value)
            << "too noisy to tell 1 % from 3 %";
        EXPECT_NEAR(mean.value, expected.value, 0.01 * expected.value) << "channel " << channel;
    }
}

// Ward's estimate is one of the share by which interpolated irradiance is wrong, made for a split
// sphere, no bound of it: here in the mean over blocks it is one, and no block exceeds twice that.
TEST_F(CornellBox, by_irradiance_cache_is_as_near_as_its_error_says) {
    constexpr float cache_error = 0.1f;
    const auto ours =
        rendered({.method = Method::irradiance, .gather = 1024, .cache_error = cache_error}, 16, 2);
    double squares = 0;
    for (std::size_t i = 0; i < reference.values.size(); ++i) {
        const double expected = reference.of_block(i).value;
        const double share = block_mean(ours, i).value / expected - 1;
        squares += share * share;
        EXPECT_LT(std::abs(share), 2 * cache_error) << place(i);
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(reference.values.size())), cache_error);
    for (std::size_t channel = 0; channel < channels; ++channel) {
        const double expected = reference.of_image(channel).value;
        EXPECT_NEAR(image_mean(ours, channel).value, expected, 0.03 * expected)
            << "channel " << channel;
    }
}

}  // namespace
}  // namespace rayshoot
