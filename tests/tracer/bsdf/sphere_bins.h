#pragma once

#include <boost/math/distributions/chi_squared.hpp>

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

    /// Of a density per solid angle, over each bin: by the midpoints of `cuts`^2 parts, which takes
    /// the jumps that some densities have as it takes the rest.
    template <class Density>
    static std::vector<double> integrals(Density&& density, std::size_t cuts = 50) {
        constexpr double pi = std::numbers::pi;
        const std::vector<Turn> polar = turns(rows * cuts, 0, pi);
        const std::vector<Turn> azimuth = turns(columns * cuts, -pi, pi);
        const double step = pi / static_cast<double>(rows * cuts);
        const double turn = 2 * pi / static_cast<double>(columns * cuts);
        std::vector<double> result(rows * columns);
        for (std::size_t i = 0; i < polar.size(); ++i) {
            const double area = step * turn * polar[i].sine;
            for (std::size_t j = 0; j < azimuth.size(); ++j) {
                const vec3 direction(dvec3(polar[i].sine * azimuth[j].cosine,
                                           polar[i].sine * azimuth[j].sine, polar[i].cosine));
                result[i / cuts * columns + j / cuts] += area * density(direction);
            }
        }
        return result;
    }

private:
    struct Turn {
        double cosine, sine;
    };
    /// Of the middles of so many steps.
    static std::vector<Turn> turns(std::size_t count, double from, double to) {
        std::vector<Turn> all;
        for (std::size_t i = 0; i < count; ++i) {
            const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            const double angle = from + (to - from) * share;
            all.push_back({std::cos(angle), std::sin(angle)});
        }
        return all;
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
