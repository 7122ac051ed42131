#include "tracer/film/adaptive.h"

#include <boost/math/distributions/chi_squared.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tracer/camera.h"

namespace rayshoot {
namespace {

double luminance(const vec3& linear) {
    return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

/// Of the sRGB curve (IEC 61966-2-1): how much a small error of a luminance shows. At white and
/// above as at white.
double display_slope(double luminance) {
    if (luminance <= 0.0031308) return 12.92;
    return 1.055 / 2.4 * std::pow(std::min(luminance, 1.0), 1 / 2.4 - 1);
}

void require_valid(const AdaptiveSettings& settings) {
    const auto check = [](bool good, const std::string& what) {
        if (!good) throw std::invalid_argument("adaptive sampling: " + what);
    };
    check(settings.least >= 2, "the first round must have 2 samples or more");
    check(settings.round >= 1, "further rounds must have 1 sample or more");
    check(settings.most >= settings.least && settings.most <= largest_spp,
          "most samples must be from those of the first round, " + std::to_string(settings.least) +
              ", to " + std::to_string(largest_spp));
    check(settings.tolerance > 0, "the tolerance must be more than 0");
    check(settings.level > 0 && settings.level < 1, "the level must be between 0 and 1");
}

}  // namespace

/// Welford 1962: no difference of large sums.
void SampleStatistics::add(const vec3& radiance) {
    const double value = luminance(radiance), deviation = value - mean_;
    mean_ += deviation / ++count_;
    squares_ += deviation * (value - mean_);
}

AdaptiveSampling::AdaptiveSampling(const AdaptiveSettings& settings) : settings_(settings) {
    require_valid(settings);
    for (int count = settings.least; count < settings.most; count += settings.round) {
        const boost::math::chi_squared distribution(count - 1);
        quantiles_.push_back(boost::math::quantile(distribution, settings.level));
        if (settings.adaptation == Adaptation::two_pass) break;
    }
}

/// Of n normal samples (n - 1) s^2 / sigma^2 is distributed as chi^2 with n - 1 degrees of freedom:
/// but for the chance `level`, sigma^2 is at most (n - 1) s^2 / quantile, and the standard error of
/// a mean of N samples is sigma / sqrt(N).
double AdaptiveSampling::needed(int round, const SampleStatistics& seen) const {
    const double quantile = quantiles_[static_cast<std::size_t>(round - 1)];
    const double variance = (seen.count() - 1) * seen.variance() / quantile;
    const double error = settings_.tolerance / display_slope(seen.mean());
    return variance / (error * error);
}

int AdaptiveSampling::next(int round, const SampleStatistics& seen) const {
    if (round == 0) return settings_.least;
    if (settings_.adaptation == Adaptation::two_pass) {
        if (round > 1) return 0;
        if (settings_.least == settings_.most) return settings_.most;
        return static_cast<int>(
            std::ceil(std::clamp<double>(needed(round, seen), settings_.least, settings_.most)));
    }
    assert(seen.count() ==
           std::min(settings_.least + (round - 1) * settings_.round, settings_.most));
    if (seen.count() >= settings_.most || needed(round, seen) <= seen.count()) return 0;
    return std::min(settings_.round, settings_.most - seen.count());
}

}  // namespace rayshoot
