#include <gtest/gtest.h>

#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <numbers>

#include "tests/tracer/film/samples.h"
#include "tests/tracer/filter/filters.h"
#include "tracer/filter/sample_sum.h"

/// What the ways of using a filter have in common, and what each of them promises.
namespace rayshoot {
namespace {

using film_tests::every_way;
using film_tests::flat_light;
using film_tests::hand_in;
using film_tests::make_tiles;
using film_tests::Sampling;
using film_tests::Way;

Image imaged(const Way& way, int width, int height, const Sampling& sampling) {
    Film film = way.film(width, height);
    hand_in(film, make_tiles(film, way, sampling));
    return film.image();
}

bool divides(const Way& way) {
    return way.reconstruction == Reconstruction::splat ||
           way.reconstruction == Reconstruction::weighted;
}

void expect_flat(const Way& way, const Sampling& sampling) {
    const Image image = imaged(way, 40, 30, sampling);
    for (const vec3& pixel : image.pixels()) {
        ASSERT_EQ(pixel, flat_light) << way.label() << ", spp " << sampling.spp;
    }
}

/// Bit for bit, to the outermost pixel, however few samples there are.
TEST(Reconstruction, a_flat_field_stays_flat_when_divided) {
    for (const Way& way : every_way()) {
        if (!divides(way) || Filter(way.filter).negative_lobes()) continue;
        for (const int spp : {1, 4, 9, 100}) {
            expect_flat(way, {.spp = spp, .flat = true, .jittered = true});
            expect_flat(way, {.spp = spp, .flat = true, .jittered = false});
        }
    }
}

/// Weights that cancel make an exception of pixels with few samples: see README.md.
TEST(Reconstruction, a_flat_field_stays_flat_under_negative_lobes_with_enough_samples) {
    for (const Way& way : every_way()) {
        if (!divides(way) || !Filter(way.filter).negative_lobes()) continue;
        if (way.splats()) expect_flat(way, {.spp = 4, .flat = true, .jittered = true});
        expect_flat(way, {.spp = 16, .flat = true, .jittered = true});
        expect_flat(way, {.spp = 100, .flat = true, .jittered = true});
    }
}

/// n equal floats are added and multiplied by 1 / n: n + 1 roundings.
TEST(Reconstruction, a_flat_field_is_flat_but_for_rounding_by_importance) {
    for (const Way& way : every_way()) {
        if (way.reconstruction != Reconstruction::importance) continue;
        if (Filter(way.filter).negative_lobes()) continue;
        const Image image = imaged(way, 40, 30, {.spp = 9, .flat = true});
        for (const vec3& pixel : image.pixels()) {
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(pixel[i] / flat_light[i], 1, 10 * 0x1p-24);
        }
    }
}

/// Literature brief of the textbook's method: with n x n jittered samples the weights that a pixel
/// gets vary, and a flat field with them. The standard deviations were computed apart from this
/// program; 200 x 200 pixels, of which about ten share a sample, tell them to 1 % or so.
TEST(Reconstruction, undivided_splats_make_a_flat_field_noisy) {
    struct Known {
        double radius, of_2, of_4;
    };
    for (const Known& known : {Known{1.5, 0.067, 0.0169}, Known{1.6, 0.059, 0.0149},
                               Known{1.7, 0.052, 0.0131}, Known{2.0, 0.037, 0.0095}}) {
        const Way way{{FilterKind::raised_cosine, known.radius}, Reconstruction::splat_undivided};
        const auto deviation = [&](int edge) {
            const auto white = [](double, double) { return vec3(1); };
            const Image image =
                imaged(way, 200, 200, {.spp = edge * edge, .jittered = true, .light = white});
            double squares = 0;
            for (const vec3& pixel : image.pixels()) squares += (pixel.x - 1) * (pixel.x - 1);
            return std::sqrt(squares / static_cast<double>(image.pixels().size()));
        };
        EXPECT_NEAR(deviation(2) / known.of_2, 1, 0.04) << known.radius;
        EXPECT_NEAR(deviation(4) / known.of_4, 1, 0.04) << known.radius;
    }
}

/// One sample gives all pixels together what the textbook's table says: 1 on average.
TEST(Reconstruction, undivided_splats_keep_the_energy_of_a_sample) {
    constexpr int size = 9, places = 40;
    for (const PrintedSampleSums& row : printed_sample_sums()) {
        const Way way{{row.kind, row.radius}, Reconstruction::splat_undivided};
        const Filter filter(way.filter);
        const SampleSums sums = sample_sums(filter);
        double mean = 0;
        for (int i = 0; i < places * places; ++i) {
            const float x = (static_cast<float>(i % places) + 0.5f) / places;
            const float y = (static_cast<float>(i / places) + 0.5f) / places;
            Film film = way.film(size, size);
            film.add(0, std::vector<FilmSample>{{{4, 4}, x, y, vec3(1), 1}});
            double energy = 0;
            const Image image = film.image();
            for (const vec3& pixel : image.pixels()) energy += pixel.y;
            EXPECT_NEAR(energy, sample_sum(filter, x, y), 1e-5);
            EXPECT_GT(energy, sums.least.sum - 1e-5);
            EXPECT_LT(energy, sums.greatest.sum + 1e-5);
            mean += energy / (places * places);
        }
        EXPECT_NEAR(mean, 1, 1e-3);
    }
}

/// Light 1 + sin(a x + b y). A filter that is even in x and y multiplies the wave by its transform
/// at (a, b) and leaves the mean.
struct Wave {
    double a = 2 * std::numbers::pi / 8, b = 2 * std::numbers::pi / 6;  // periods divide the image

    double operator()(double x, double y) const { return std::sin(a * x + b * y); }
    double transform(const Filter& filter) const {
        return filter_tests::over_support(filter,
                                          [&](double x, double y) {
                                              return filter(x, y) * std::cos(a * x) *
                                                     std::cos(b * y);
                                          }) /
               filter.integral();
    }
};

struct Measured {
    double amplitude = 0, level = 0;
};

Measured measured(const Way& way, const Sampling& sampling) {
    constexpr int size = 48;
    const Wave wave;
    Sampling of_wave = sampling;
    of_wave.light = [&](double x, double y) { return vec3(static_cast<float>(1 + wave(x, y))); };
    const Image image = imaged(way, size, size, of_wave);
    Measured sums;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const double pixel = image.at(x, y).x;
            sums.amplitude += 2 * pixel * wave(x + 0.5, y + 0.5) / (size * size);
            sums.level += pixel / (size * size);
        }
    }
    return sums;
}

constexpr int repeats = 16;
/// Chance of a correct mean to fail, in each of the tests; seeds are fixed.
constexpr double level_of_test = 1e-5;

/// Null hypothesis: values are normal with mean `wanted`, give or take `bias`.
void expect_mean(const std::array<double, repeats>& values, double wanted, double bias,
                 const std::string& what) {
    double mean = 0, squares = 0;
    for (const double value : values) mean += value / repeats;
    for (const double value : values) squares += (value - mean) * (value - mean);
    const double error = std::sqrt(squares / (repeats - 1) / repeats);
    const boost::math::students_t distribution(repeats - 1);
    const double limit = error * quantile(complement(distribution, level_of_test / 2));
    EXPECT_NEAR(mean, wanted, limit + bias) << what << ", standard error " << error;
    EXPECT_LT(limit, 0.02) << what << ": tells nothing";
}

/// Quotients of sums are biased by less than the relative variance of their divisor, for light
/// between 0 and 2 by twice that: 2 E(w^2) / (n E(w)^2) with n independent samples in the support.
double bias_of_quotient(const Way& way, int spp) {
    const Filter filter(way.filter);
    const double squares = filter_tests::over_support(
        filter, [&](double x, double y) { return filter(x, y) * filter(x, y); });
    const double share = squares / (filter.integral() * filter.integral() * spp);
    if (way.reconstruction == Reconstruction::splat) return 2 * share;
    const double area = filter_tests::over_support(filter, [](double, double) { return 1; });
    return 2 * area * share;
}

void expect_filtered(const Way& way, bool jittered, int spp) {
    std::array<double, repeats> amplitudes, levels;
    for (std::size_t i = 0; i < repeats; ++i) {
        const auto [amplitude, level] = measured(
            way, {.spp = spp, .jittered = jittered, .seed = static_cast<std::uint32_t>(i)});
        amplitudes[i] = amplitude;
        levels[i] = level;
    }
    const double bias = divides(way) ? bias_of_quotient(way, spp) : 0;
    // Weights in float, from a table; sums of importance in float.
    constexpr double rounding = 5e-6;
    const std::string what = way.label() + (jittered ? " jittered" : " random");
    expect_mean(amplitudes, Wave().transform(Filter(way.filter)), bias + rounding, what);
    expect_mean(levels, 1, bias + rounding, what);
}

/// All ways have the same limit, the filtered light at the middle of each pixel; those that do not
/// divide have it for any number of samples.
TEST(Reconstruction, means_and_undivided_splats_are_unbiased) {
    for (const Way& way : every_way()) {
        if (divides(way)) continue;
        expect_filtered(way, true, 4);
        expect_filtered(way, false, 3);
    }
}

TEST(Reconstruction, quotients_converge_to_the_same_light) {
    for (const Way& way : every_way()) {
        if (divides(way)) expect_filtered(way, true, 64);
    }
}

/// So that the above means something: the filters' transforms differ by more than is allowed.
TEST(Reconstruction, another_filter_would_be_noticed) {
    const Wave wave;
    const double cone = wave.transform(Filter({FilterKind::cone, 1.7}));
    const double cosine = wave.transform(Filter({FilterKind::raised_cosine, 1.7}));
    EXPECT_GT(std::abs(cone - cosine), 0.02);
}

}  // namespace
}  // namespace rayshoot
