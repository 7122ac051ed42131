#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tests/tracer/sampling/kinds.h"
#include "tracer/camera.h"

namespace rayshoot {
namespace {

/// Over the unit square.
struct Integrand {
    const char* name;
    std::function<double(Pair)> value;
    double integral;
};

Integrand smooth() {
    return {"smooth", [](Pair p) { return std::exp(double{p.u} + double{p.v}); },
            std::pow(std::numbers::e - 1, 2)};
}

/// A quarter disc: its edge is at every angle to the strata.
Integrand edge() {
    constexpr double radius = 0.8;
    const auto inside = [](Pair p) { return p.u * p.u + p.v * p.v < radius * radius ? 1.0 : 0.0; };
    return {"edge", inside, std::numbers::pi * radius * radius / 4};
}

constexpr int pixels = 2000;  // the error's relative deviation is 1 / sqrt(2 pixels), 1.6 %

double error(const Sampler& sampler, Use use, const Integrand& integrand) {
    double squares = 0;
    for (std::int16_t x = 0; x < pixels; ++x) {
        double sum = 0;
        for (const std::uint32_t s : samples(sampler.settings().spp)) {
            sum += integrand.value(sampler.pair({x, 11}, s, {use}));
        }
        squares += std::pow(sum / sampler.settings().spp - integrand.integral, 2);
    }
    return std::sqrt(squares / pixels);
}

/// The power p of error ~ spp^p: least squares of the logarithms. Its deviation from the errors' is
/// 0.006.
double power(SamplerSettings settings, Use use, const Integrand& integrand) {
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const int spp : {16, 64, 256, 1024}) {
        settings.spp = spp;
        const double x = std::log(spp), y = std::log(error(Sampler(settings), use, integrand));
        n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// The tolerance is four deviations, and what 16 samples still lack of the limit.
constexpr double tolerance = 0.05;

TEST(Convergence, random_numbers_err_by_the_root_of_their_count) {
    for (const Integrand& integrand : {smooth(), edge()}) {
        EXPECT_NEAR(power({SamplerKind::random}, Use::pixel, integrand), -0.5, tolerance)
            << integrand.name;
    }
}

/// Strata of edge N^-1/2: a smooth integrand varies by as much in each, so its mean over N of them
/// by N^-1. An edge passes through N^1/2 strata, each of which errs by N^-1: N^-3/4 together
/// (Mitchell 1996).
TEST(Convergence, jitter_errs_by_the_count_and_at_an_edge_by_its_three_quarters) {
    for (const Use use : {Use::pixel, Use::light}) {
        EXPECT_NEAR(power({SamplerKind::jitter}, use, smooth()), -1, tolerance);
        EXPECT_NEAR(power({SamplerKind::jitter}, use, edge()), -0.75, tolerance);
    }
}

/// Scrambled nets err by N^-3/2 of a smooth integrand, up to logarithms (Owen 1997).
TEST(Convergence, sobol_errs_by_more_than_the_count) {
    for (const bool blue_noise : {false, true}) {
        const SamplerSettings sobol{SamplerKind::sobol, 1, blue_noise};
        EXPECT_NEAR(power(sobol, Use::light, smooth()), -1.45, 2 * tolerance);
        EXPECT_NEAR(power(sobol, Use::light, edge()), -0.75, tolerance);
    }
}

TEST(Convergence, at_sixteen_samples_strata_help_and_sobol_more) {
    const auto at_sixteen = [](SamplerKind kind) {
        return error(Sampler({kind, 16}), Use::light, smooth());
    };
    EXPECT_LT(at_sixteen(SamplerKind::jitter), 0.4 * at_sixteen(SamplerKind::random));
    EXPECT_LT(at_sixteen(SamplerKind::sobol), 0.8 * at_sixteen(SamplerKind::jitter));
}

/// Independent means of many pixels agree with the integral, for kinds that are unbiased: within
/// 4.4 deviations of the mean.
TEST(Convergence, unbiased_kinds_converge_to_the_integral_over_pixels) {
    for (const SamplerSettings& settings : every_kind(9)) {
        if (settings.blue_noise) continue;  // pixels are not independent: better than that
        for (const Integrand& integrand : {smooth(), edge()}) {
            const Sampler sampler(settings);
            double sum = 0, squares = 0;
            for (std::int16_t x = 0; x < pixels; ++x) {
                double mean = 0;
                for (const std::uint32_t s : samples(9)) {
                    mean += integrand.value(sampler.pair({x, 3}, s, {Use::lobe})) / 9;
                }
                sum += mean - integrand.integral;
                squares += std::pow(mean - integrand.integral, 2);
            }
            EXPECT_LT(std::abs(sum), 4.4 * std::sqrt(squares)) << name(settings.kind);
        }
    }
}

/// Of what a moving edge lets through while the shutter is open, over 16 jittered samples: a place
/// x is lit until the time 1/2 - x.
double moving_edge_error(bool cook_time) {
    const Sampler sampler({SamplerKind::jitter, 16, false, cook_time});
    double squares = 0;
    for (std::int16_t x = 0; x < pixels; ++x) {
        double seen = 0;
        for (const std::uint32_t s : samples(16)) {
            const float place = sampler.pair({x, 0}, s, {Use::pixel}).u;
            seen += place + sampler.number({x, 0}, s, {Use::time}) < 0.5f ? 1 : 0;
        }
        squares += std::pow(seen / 16 - 0.125, 2);
    }
    return std::sqrt(squares / pixels);
}

TEST(Convergence, cooks_times_help_at_moving_edges) {
    EXPECT_LT(moving_edge_error(true), 0.85 * moving_edge_error(false));
}

}  // namespace
}  // namespace rayshoot
