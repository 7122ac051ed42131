#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <array>
#include <numbers>
#include <string>
#include <vector>

#include "tracer/filter/filter.h"

/// Filters to test, and integrals over them by quadrature.
namespace rayshoot::filter_tests {

inline constexpr std::array all_kinds{FilterKind::box,           FilterKind::cone,
                                      FilterKind::raised_cosine, FilterKind::gaussian,
                                      FilterKind::mitchell,      FilterKind::blackman_harris};

/// Every kind at radii from the smallest to large ones, whole, half and odd ones among them.
inline std::vector<Filter> all_filters() {
    std::vector<Filter> filters;
    for (const FilterKind kind : all_kinds) {
        for (const double radius : {0.5, 0.75, 1.5, 1.7, 2.0, 5.3}) {
            filters.emplace_back(FilterSettings{kind, radius});
        }
    }
    return filters;
}

inline std::string label(const Filter& filter) {
    return std::string(name(filter.settings().kind)) + " " +
           std::to_string(filter.settings().radius);
}

/// Where pieces of a filter's profile meet or change sign, over R: so that quadrature is exact.
inline constexpr std::array seams{-1.0, -4.0 / 7, -0.5, 0.0, 0.5, 4.0 / 7, 1.0};

/// Integral of f from `from` to `to`, which lie in [-R, R]; smooth but at the seams.
template <class F>
double integral(double from, double to, double radius, F&& f) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < seams.size(); ++i) {
        const double lo = std::max(from, radius * seams[i]);
        const double hi = std::min(to, radius * seams[i + 1]);
        // One panel without subdivision: 61 points are exact for these functions.
        if (lo < hi) {
            sum += boost::math::quadrature::gauss_kronrod<double, 61>::integrate(f, lo, hi, 0);
        }
    }
    return sum;
}

/// Integral of f(x, y) over the filter's support.
template <class F>
double over_support(const Filter& filter, F&& f) {
    const double radius = filter.settings().radius;
    if (filter.separable()) {
        return integral(-radius, radius, radius, [&](double y) {
            return integral(-radius, radius, radius, [&](double x) { return f(x, y); });
        });
    }
    return integral(0, radius, radius, [&](double r) {
        return r * boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
                       [&](double a) { return f(r * std::cos(a), r * std::sin(a)); }, 0.0,
                       2 * std::numbers::pi, 0);
    });
}

}  // namespace rayshoot::filter_tests
