#pragma once

#include <cstdint>
#include <span>

/// Medians with bootstrap confidence intervals: what every timing is reported as.
namespace rayshoot {

struct Estimate {
    double median = 0;
    double low = 0, high = 0;  ///< bounds of the confidence interval

    /// Two rows whose intervals overlap are reported as no different.
    bool overlaps(const Estimate& other) const { return low <= other.high && other.low <= high; }
};

/// Mean of the two middle samples when their number is even. Throws for no samples.
double median(std::span<const double> samples);

inline constexpr double default_confidence = 0.95;
inline constexpr int default_resamples = 2000;  // interval ends repeat within 1 % of the spread

/// Percentile bootstrap of the median (Efron 1979), seeded: equal samples give equal intervals.
/// One sample gives an interval of no width: nothing is known of its spread.
Estimate bootstrap_median(std::span<const double> samples, double confidence = default_confidence,
                          int resamples = default_resamples, std::uint64_t seed = 1);

/// Half the interquartile range over the median: how much a machine wavers.
double relative_spread(std::span<const double> samples);

}  // namespace rayshoot
