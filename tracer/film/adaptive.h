#pragma once

#include "accel/core/vec.h"

#include <cstdint>
#include <vector>

/// How many samples a pixel takes: more where they disagree (Lee, Redner & Uselton 1985).
namespace rayshoot {

/// sequential: rounds are added until the test passes. Biased: a pixel that has seen nothing of a
/// rare event stops too soon. two_pass: the first round only decides how long the second one is,
/// and is thrown away. Not biased (Kirk & Arvo 1991), but dearer.
enum class Adaptation : std::uint8_t { sequential, two_pass };

struct AdaptiveSettings {
    Adaptation adaptation = Adaptation::sequential;
    int least = 16;  ///< samples of the first round; 2 at least
    int round = 16;  ///< samples of each further round, sequential; 1 at least
    int most = 256;  ///< samples that enter a pixel; `least` to largest_spp
    /// Wanted standard error of a pixel's luminance, as displayed: as a share of white after the
    /// sRGB curve. More than 0.
    double tolerance = 1.0 / 255;
    /// Chance of stopping although the error is larger, if samples were normal. In (0, 1).
    double level = 0.05;
};

/// Number, mean and variance of a pixel's samples so far.
class SampleStatistics {
public:
    void add(const vec3& radiance);  ///< linear; its luminance counts (ITU-R BT.709)
    int count() const { return count_; }
    double mean() const { return mean_; }
    /// Unbiased; 0 for less than two samples.
    double variance() const { return count_ < 2 ? 0 : squares_ / (count_ - 1); }

private:
    int count_ = 0;
    double mean_ = 0, squares_ = 0;  ///< squares: of deviations from the mean
};

/// The stopping rule, alike for all pixels; it looks at a pixel's own samples alone, so that
/// images depend on neither threads nor tiles. A pixel is done by
///     for (int round = 0; const int count = rule.next(round, seen); ++round)
/// with `count` samples traced and added to `seen` each time. Each round should be stratified on
/// its own.
class AdaptiveSampling {
public:
    /// Throws std::invalid_argument for settings out of range.
    explicit AdaptiveSampling(const AdaptiveSettings& settings);

    /// Samples to take in round `round`, from 0 on, after those that were `seen`; 0: done.
    int next(int round, const SampleStatistics& seen) const;
    /// Whether the samples of this round enter the pixel: all but two_pass's first.
    bool keeps(int round) const {
        return round > 0 || settings_.adaptation == Adaptation::sequential;
    }
    const AdaptiveSettings& settings() const { return settings_; }

private:
    double needed(int round, const SampleStatistics& seen) const;

    AdaptiveSettings settings_;
    std::vector<double> quantiles_;  ///< of chi^2 at `level`, by round
};

}  // namespace rayshoot
