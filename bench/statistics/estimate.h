#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

/// The geometric mean over groups of each group's median, as `median`; the interval by resampling
/// within every group, so it speaks of how well these groups were measured, not of other groups.
/// All samples are positive. Throws for no group and for a group without samples.
Estimate bootstrap_geometric_mean(std::span<const std::vector<double>> groups,
                                  double confidence = default_confidence,
                                  int resamples = default_resamples, std::uint64_t seed = 1);

/// Half the interquartile range over the median: how much a machine wavers.
double relative_spread(std::span<const double> samples);

/// From the 2.5 % quantile to the 97.5 %, over the median: how far samples moved. A single
/// disturbed sample of many does not count, a disturbance that lasts does. Of up to 20
/// samples these quantiles are the lowest and the highest.
double central_range(std::span<const double> samples);

}  // namespace rayshoot
