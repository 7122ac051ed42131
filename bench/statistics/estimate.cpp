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

/// The median of as many samples, drawn with repetition.
double drawn_median(std::span<const double> samples, std::vector<double>& drawn, Sequence& random) {
    drawn.resize(samples.size());
    for (double& value : drawn) value = samples[random.below(samples.size())];
    return middle_of(drawn);
}

Estimate percentile_interval(double centre, std::vector<double> resampled, double confidence) {
    std::sort(resampled.begin(), resampled.end());
    const double tail = 0.5 * (1 - confidence);
    return {centre, quantile(resampled, tail), quantile(resampled, 1 - tail)};
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
    std::vector<double> drawn, medians;
    for (int i = 0; i < resamples; ++i) medians.push_back(drawn_median(samples, drawn, random));
    return percentile_interval(centre, std::move(medians), confidence);
}

Estimate bootstrap_geometric_mean(std::span<const std::vector<double>> groups, double confidence,
                                  int resamples, std::uint64_t seed) {
    if (groups.empty()) throw std::invalid_argument("a mean of no groups was asked for");
    const auto mean = [&](auto&& middle) {
        double sum = 0;
        for (const std::vector<double>& group : groups) sum += std::log(middle(group));
        return std::exp(sum / static_cast<double>(groups.size()));
    };
    const double centre = mean([](const auto& group) { return median(group); });
    Sequence random(seed);
    std::vector<double> drawn, means;
    for (int i = 0; i < resamples; ++i) {
        means.push_back(
            mean([&](const auto& group) { return drawn_median(group, drawn, random); }));
    }
    return percentile_interval(centre, std::move(means), confidence);
}

double relative_spread(std::span<const double> samples) {
    require_samples(samples);
    std::vector<double> sorted(samples.begin(), samples.end());
    std::sort(sorted.begin(), sorted.end());
    const double centre = median(samples);
    if (centre == 0) return 0;
    return 0.5 * (quantile(sorted, 0.75) - quantile(sorted, 0.25)) / centre;
}

double central_range(std::span<const double> samples) {
    const double centre = median(samples);
    std::vector<double> sorted(samples.begin(), samples.end());
    std::sort(sorted.begin(), sorted.end());
    if (centre == 0) return 0;
    return (quantile(sorted, 0.975) - quantile(sorted, 0.025)) / centre;
}

}  // namespace rayshoot
