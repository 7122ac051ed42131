#pragma once

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "accel/core/vec.h"

/// The sphere of directions in bins of equal steps in polar angle and azimuth; the horizon is
/// between bins.
namespace rayshoot::tracer_tests {

class SphereBins {
public:
    static constexpr std::size_t rows = 20, columns = 40;

    /// Row, then column.
    static std::size_t bin(const vec3& direction) {
        constexpr double pi = std::numbers::pi;
        const double polar = std::acos(std::clamp(double{direction.z}, -1.0, 1.0));
        const double turn = std::atan2(double{direction.y}, double{direction.x}) / (2 * pi) + 0.5;
        const auto place = [](double share, std::size_t count) {
            const auto of = static_cast<double>(count);
            return std::min(static_cast<std::size_t>(share * of), count - 1);
        };
        return place(polar / pi, rows) * columns + place(turn, columns);
    }

    /// Of a density per solid angle, over each bin. By Gauss quadrature in `cuts`^2 parts of it.
    template <class Density>
    static std::vector<double> integrals(Density&& density, int cuts = 3) {
        std::vector<double> result;
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t column = 0; column < columns; ++column)
                result.push_back(integral(density, row, column, cuts));
        return result;
    }

private:
    template <class Density>
    static double integral(Density& density, std::size_t row, std::size_t column, int cuts) {
        constexpr double pi = std::numbers::pi;
        using Rule = boost::math::quadrature::gauss<double, 7>;
        const double step = pi / rows / cuts, turn = 2 * pi / columns / cuts;
        double sum = 0;
        for (int i = 0; i < cuts; ++i) {
            for (int j = 0; j < cuts; ++j) {
                const double polar = pi * static_cast<double>(row) / rows + i * step;
                const double azimuth =
                    2 * pi * static_cast<double>(column) / columns - pi + j * turn;
                const auto at = [&](double theta, double phi) {
                    const vec3 direction(dvec3(std::sin(theta) * std::cos(phi),
                                               std::sin(theta) * std::sin(phi), std::cos(theta)));
                    return density(direction) * std::sin(theta);
                };
                sum += Rule::integrate(
                    [&](double theta) {
                        return Rule::integrate([&](double phi) { return at(theta, phi); }, azimuth,
                                               azimuth + turn);
                    },
                    polar, polar + step);
            }
        }
        return sum;
    }
};

/// The probability that chi^2 of such counts is at least as large, if `expected` is what is
/// expected of them. Bins of which less than five are expected are put together.
inline double chi_squared_p(const std::vector<double>& counts,
                            const std::vector<double>& expected) {
    double sum = 0, rest_count = 0, rest_expected = 0;
    int terms = 0;
    const auto add = [&](double count, double mean) {
        sum += (count - mean) * (count - mean) / mean;
        ++terms;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] >= 5) {
            add(counts[i], expected[i]);
        } else {
            rest_count += counts[i];
            rest_expected += expected[i];
        }
    }
    if (rest_expected >= 5) add(rest_count, rest_expected);
    else if (rest_count > rest_expected + 25) return 0;  // many where next to none may be
    if (terms < 2) return 1;
    const boost::math::chi_squared distribution(terms - 1);
    return boost::math::cdf(boost::math::complement(distribution, sum));
}

}  // namespace rayshoot::tracer_tests
