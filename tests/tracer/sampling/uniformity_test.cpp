#include <gtest/gtest.h>

#include "tests/tracer/sampling/kinds.h"
#include "tracer/camera.h"

namespace rayshoot {
namespace {

constexpr int edge = 128;  // of the image, pixels: 16384 samples a test, of different pixels
constexpr std::size_t cells = 8;

/// Each pixel once, with one of its samples: those of one pixel are not independent.
template <class Visit>
void each_pixel(int spp, Visit&& visit) {
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
            const int sample = (y * edge + x) * 7 % spp;  // 7: all samples, were there no remainder
            visit(Pixel{static_cast<std::int16_t>(x - edge / 2), static_cast<std::int16_t>(y)},
                  static_cast<std::uint32_t>(sample));
        }
    }
}

std::size_t square(float u, float v) { return cell(v, cells) * cells + cell(u, cells); }

/// Whether the pixel's pairs of the kind are not uniform, but a lattice or bells.
bool biased(SamplerKind kind) {
    return kind == SamplerKind::regular || kind == SamplerKind::gaussian;
}

/// Null hypothesis: pairs are uniform on the square, 64 cells. Blue noise stratifies over pixels,
/// too, so its chi^2 is less than by chance.
TEST(Uniformity, pairs_of_every_kind_and_use) {
    for (const int spp : {1, 9, 16}) {
        for (const SamplerSettings& settings : every_kind(spp)) {
            const Sampler sampler(settings);
            for (const Use use : every_use) {
                if (use == Use::pixel && (spp == 1 || biased(settings.kind))) continue;
                Histogram histogram(cells * cells);
                each_pixel(spp, [&](Pixel pixel, std::uint32_t sample) {
                    const auto [u, v] = sampler.pair(pixel, sample, {use});
                    histogram.add(square(u, v));
                });
                EXPECT_TRUE(histogram.uniform())
                    << name(settings.kind) << " " << spp << " use " << static_cast<int>(use);
            }
        }
    }
}

/// The same of each single sample over pixels: what permutations must not prefer.
TEST(Uniformity, each_sample_of_every_kind) {
    for (const SamplerSettings& settings : every_kind(9)) {
        const Sampler sampler(settings);
        for (const std::uint32_t sample : samples(9)) {
            Histogram pairs(cells * cells), times(cells * cells);
            each_pixel(9, [&](Pixel pixel, std::uint32_t) {
                const auto [u, v] = sampler.pair(pixel, sample, {Use::lens});
                pairs.add(square(u, v));
                times.add(cell(sampler.number(pixel, sample, {Use::time}), cells * cells));
            });
            EXPECT_TRUE(pairs.uniform()) << name(settings.kind) << " sample " << sample;
            EXPECT_TRUE(times.uniform()) << name(settings.kind) << " sample " << sample;
        }
    }
}

/// Null hypothesis: numbers are uniform, 64 intervals.
TEST(Uniformity, numbers_of_every_kind_and_use) {
    for (const int spp : {1, 9, 16}) {
        for (const SamplerSettings& settings : every_kind(spp)) {
            const Sampler sampler(settings);
            for (const Use use : every_use) {
                Histogram histogram(cells * cells);
                each_pixel(spp, [&](Pixel pixel, std::uint32_t sample) {
                    histogram.add(cell(sampler.number(pixel, sample, {use, 2}), cells * cells));
                });
                EXPECT_TRUE(histogram.uniform()) << name(settings.kind) << " " << spp;
            }
        }
    }
}

/// Null hypothesis: a truncated Gaussian of 1/4 stratum in each of the 4 x 4 strata, 20 intervals.
TEST(Uniformity, gaussian_samples_are_gaussian_in_their_strata) {
    const auto distribution = [](double x) {
        return std::erf((x - 0.5) / 0.25 / std::sqrt(2.0)) / (2 * std::erf(std::sqrt(2.0)));
    };
    constexpr std::size_t bins = 20;
    const Sampler sampler({SamplerKind::gaussian, 16});
    Histogram across(bins), down(bins);
    each_pixel(16, [&](Pixel pixel, std::uint32_t sample) {
        const auto [u, v] = sampler.pair(pixel, sample, {});
        across.add(cell(4 * u - std::floor(4 * u), bins));
        down.add(cell(4 * v - std::floor(4 * v), bins));
    });
    for (const Histogram* histogram : {&across, &down}) {
        EXPECT_TRUE(histogram->agrees([&](std::size_t bin) {
            const double lo = static_cast<double>(bin) / bins;
            return distribution(lo + 1.0 / bins) - distribution(lo);
        }));
    }
}

/// Null hypothesis: two pairs of dimensions of a sample are independent, 64 cells each way that one
/// coordinate of either can be taken.
template <class First, class Second>
void expect_independent(const SamplerSettings& settings, First&& first, Second&& second) {
    Histogram uu(cells * cells), uv(cells * cells), vv(cells * cells);
    each_pixel(settings.spp, [&](Pixel pixel, std::uint32_t sample) {
        const Pair a = first(pixel, sample), b = second(pixel, sample);
        uu.add(square(a.u, b.u));
        uv.add(square(a.u, b.v));
        vv.add(square(a.v, b.v));
    });
    for (const Histogram* histogram : {&uu, &uv, &vv}) {
        EXPECT_TRUE(histogram->uniform()) << name(settings.kind) << " " << settings.spp;
    }
}

TEST(Independence, of_dimensions) {
    for (const SamplerSettings& settings : every_kind(16)) {
        const Sampler sampler(settings);
        const auto of = [&](Dimension dimension) {
            return [&sampler, dimension](Pixel pixel, std::uint32_t sample) {
                return sampler.pair(pixel, sample, dimension);
            };
        };
        const Dimension light{Use::light};
        expect_independent(settings, of(light), of({Use::lens}));
        expect_independent(settings, of(light), of({Use::lobe}));
        expect_independent(settings, of(light), of(light.child(0)));
        expect_independent(settings, of(light.child(0)), of(light.child(1)));
        expect_independent(settings, of(light.child(2)), of(light.child(3)));
        if (!biased(settings.kind)) expect_independent(settings, of({Use::pixel}), of(light));
    }
}

TEST(Independence, of_neighbouring_pixels) {
    for (const SamplerSettings& settings : every_kind(16)) {
        if (settings.blue_noise) continue;  // whose neighbours are to complement each other
        const Sampler sampler(settings);
        const auto at = [&](int dx, int dy) {
            return [&sampler, dx, dy](Pixel pixel, std::uint32_t sample) {
                // Spread out, so that no pixel is in two pairs.
                return sampler.pair({static_cast<std::int16_t>(2 * pixel.x + dx),
                                     static_cast<std::int16_t>(2 * pixel.y + dy)},
                                    sample, {Use::lens});
            };
        };
        expect_independent(settings, at(0, 0), at(1, 0));
        expect_independent(settings, at(0, 0), at(0, 1));
    }
}

/// Null hypothesis: over pixels the correlation of two dimensions over a pixel's 16 samples has
/// mean 0. Its deviation is 1 / sqrt(15) in a pixel, for a random permutation.
TEST(Independence, samples_of_a_pixel_are_dealt_at_random) {
    for (const SamplerSettings& settings : every_kind(16)) {
        const Sampler sampler(settings);
        double sum = 0;
        each_pixel(16, [&](Pixel pixel, std::uint32_t) {
            for (const std::uint32_t s : samples(16)) {
                sum += (sampler.number(pixel, s, {Use::time}) - 0.5) *
                       (sampler.pair(pixel, s, {Use::pixel}).u - 0.5);
            }
        });
        const double correlation = sum / (16 * edge * edge) * 12;
        EXPECT_LT(std::abs(correlation), 4.4 / std::sqrt(15) / edge) << name(settings.kind);
    }
}

}  // namespace
}  // namespace rayshoot
