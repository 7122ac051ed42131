#pragma once

#include <span>

namespace rayshoot {

/// y = factor * x^exponent, the least-squares line through the logarithms.
struct PowerLaw {
    double factor = 0, exponent = 0;
    double standard_error = 0;  ///< of the exponent; 0 for two points, of which nothing is known
};

/// Throws std::invalid_argument unless there are two different x, as many y, and all are positive.
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace rayshoot
