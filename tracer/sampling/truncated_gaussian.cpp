#include "tracer/sampling/truncated_gaussian.h"

#include <cmath>

namespace rayshoot {
namespace {

constexpr double end = 0.5 / TruncatedGaussian::deviation;  // in standard deviations

/// The integral of exp(-t^2 / 2) from 0 to x, 0 <= x <= end, by its power series: std::erf may
/// differ in the last bit from one C library to the next.
double gaussian_integral(double x) {
    double power = x, sum = 0;
    for (int k = 0; std::abs(power) > 1e-17; ++k) {
        sum += power / (2 * k + 1);
        power *= -x * x / (2 * (k + 1));
    }
    return sum;
}

/// Where the integral is `share` of that up to the end.
double quantile(double share) {
    double lo = 0, hi = end;
    for (int bit = 0; bit < 40; ++bit) {  // 32 are kept
        const double middle = (lo + hi) / 2;
        (gaussian_integral(middle) < share * gaussian_integral(end) ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

}  // namespace

TruncatedGaussian::TruncatedGaussian() {
    constexpr int half = 1 << (31 - interval_bits);
    quantiles_.resize(2 * half + 1);
    for (int i = 0; i <= half; ++i) {
        const double distance = TruncatedGaussian::deviation * quantile(i / double{half});
        const auto offset = static_cast<std::uint32_t>(distance * 0x1p32);
        quantiles_[static_cast<std::size_t>(half + i)] =
            0x80000000u + (i < half ? offset : ~0u >> 1);
        quantiles_[static_cast<std::size_t>(half - i)] =
            0x80000000u - (i < half ? offset : 1u << 31);
    }
}

}  // namespace rayshoot
