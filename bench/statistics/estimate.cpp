#include "bench/statistics/estimate.h"

#include "bench/statistics/random.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace rayshoot {
namespace {

double middle_of(std::span<double> samples) {
    const auto half = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
    std::nth_element(samples.begin(), half, samples.end());
    if (samples.size() % 2 == 1) return *half;
    return 0.5 * (*std::max_element(samples.begin(), half) + *half);
}

/// The share `p` of sorted samples, rounded to the sample that lies there.
double quantile(std::span<const double> sorted, double p) {
    const double last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(std::lround(p * last))];
}

void require_samples(std::span<const double> samples) {
    if (samples.empty()) throw std::invalid_argument("statistics of no samples were asked for");
}

}  // namespace

double median(std::span<const double> samples) {
    require_samples(samples);
    std::vector<double> copy(samples.begin(), samples.end());
    return middle_of(copy);
}

Estimate bootstrap_median(std::span<const double> samples, double confidence, int resamples,
                          std::uint64_t seed) {
    const double centre = median(samples);
    Sequence random(seed);
    std::vector<double> drawn(samples.size());
    std::vector<double> medians;
    for (int i = 0; i < resamples; ++i) {
        for (double& value : drawn) value = samples[random.below(samples.size())];
        medians.push_back(middle_of(drawn));
    }
    std::sort(medians.begin(), medians.end());
    const double tail = 0.5 * (1 - confidence);
    return {centre, quantile(medians, tail), quantile(medians, 1 - tail)};
}

double relative_spread(std::span<const double> samples) {
    require_samples(samples);
    std::vector<double> sorted(samples.begin(), samples.end());
    std::sort(sorted.begin(), sorted.end());
    const double centre = median(samples);
    if (centre == 0) return 0;
    return 0.5 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / centre;
}

}  // namespace rayshoot
