#include "bench/statistics/power_law.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace rayshoot {
namespace {

TEST(PowerLaw, finds_the_law_that_made_the_values) {
    const std::array<double, 4> x{1000, 5000, 20000, 1e6};
    std::array<double, 4> y;
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = 3e-7 * std::pow(x[i], 1.25);
    const PowerLaw law = fit_power_law(x, y);
    EXPECT_NEAR(law.exponent, 1.25, 1e-12);
    EXPECT_NEAR(law.factor, 3e-7, 1e-17);
    EXPECT_NEAR(law.standard_error, 0, 1e-12);
}

/// Logarithms (0, 0), (1, 1), (2, 0): slope 0, level 1/3, residuals 6/9 over one degree of freedom,
/// spread 2, so the error is sqrt(1/3).
TEST(PowerLaw, standard_error_is_that_of_a_slope) {
    const std::array<double, 3> x{1, std::exp(1.0), std::exp(2.0)}, y{1, std::exp(1.0), 1};
    const PowerLaw law = fit_power_law(x, y);
    EXPECT_NEAR(law.exponent, 0, 1e-12);
    EXPECT_NEAR(law.factor, std::exp(1.0 / 3), 1e-12);
    EXPECT_NEAR(law.standard_error, std::sqrt(1.0 / 3), 1e-12);
}

TEST(PowerLaw, of_what_gives_none_is_refused) {
    const std::array<double, 2> same{7, 7}, values{1, 2}, signs{1, -2};
    const std::array<double, 1> one{3};
    EXPECT_THROW(fit_power_law(same, values), std::invalid_argument);
    EXPECT_THROW(fit_power_law(values, signs), std::invalid_argument);
    EXPECT_THROW(fit_power_law(signs, values), std::invalid_argument);
    EXPECT_THROW(fit_power_law(values, one), std::invalid_argument);
    EXPECT_THROW(fit_power_law(one, one), std::invalid_argument);
    EXPECT_THROW(fit_power_law({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
