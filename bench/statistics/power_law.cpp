#include "bench/statistics/power_law.h"

#include "bench/statistics/estimate.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace rayshoot {
namespace {

std::vector<double> logarithms(std::span<const double> values) {
    std::vector<double> logs;
    for (const double value : values) {
        if (!(value > 0) || std::isinf(value))
            throw std::invalid_argument("a power law is fitted to positive numbers");
        logs.push_back(std::log(value));
    }
    return logs;
}

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

}  // namespace

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y) {
    const std::vector<double> at = logarithms(x), value = logarithms(y);
    if (at.size() != value.size() || at.empty() || std::ranges::min(at) == std::ranges::max(at))
        throw std::invalid_argument(
            "a power law is fitted to pairs of two different sizes at least");
    const double middle = mean(at), level = mean(value);
    double spread = 0, together = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        spread += (at[i] - middle) * (at[i] - middle);
        together += (at[i] - middle) * (value[i] - level);
    }
    PowerLaw law;
    law.exponent = together / spread;
    law.factor = std::exp(level - law.exponent * middle);
    double residual = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const double off = value[i] - level - law.exponent * (at[i] - middle);
        residual += off * off;
    }
    if (at.size() > 2)
        law.standard_error = std::sqrt(residual / static_cast<double>(at.size() - 2) / spread);
    return law;
}

}  // namespace rayshoot
