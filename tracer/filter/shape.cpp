#include "tracer/filter/shape.h"

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace rayshoot::shape {
namespace {

using std::numbers::pi;

/// Solves cumulative(s) = u by Newton's method within a bracket that shrinks.
template <class Shape>
double solved(double u) {
    constexpr int digits = 26;     // bits of the last step but one: the last one doubles them
    constexpr double start = 0.3;  // times u: left of the root, about right in the middle
    std::uintmax_t steps = 64;     // near a double root each gains a bit
    const auto equation = [u](double s) {
        return std::pair(Shape::cumulative(s) - u, Shape::density(s));
    };
    return boost::math::tools::newton_raphson_iterate(equation, start * u, 0.0, 1.0, digits, steps);
}

struct Box {
    static double weight(double) { return 1; }
    static Integral integral() { return {2, 2}; }
    static double cumulative(double s) { return s; }
    static double quantile(double u) { return u; }
};

struct Cone {
    static double weight(double s) { return 1 - s; }
    static Integral integral() { return {pi / 3, pi / 3}; }
    static double cumulative(double s) { return s * s * (3 - 2 * s); }
    /// The cubic has three real roots; this is Viete's middle one.
    static double quantile(double u) { return 0.5 - std::sin(std::asin(1 - 2 * u) / 3); }
};

/// The textbook asks why the distribution of r is "a bit tricky". The weight is a density over the
/// plane: a ring of radius r and width dr has area 2 pi r dr, so that r has the density
/// 2 pi r w(r), not w(r). It is 0 in the middle, where w is greatest. And while its integral is
/// elementary, it mixes s^2, s sin and cos, so its inverse is not: equation by Newton.
struct RaisedCosine {
    static constexpr double ring_integral = 0.5 - 2 / (pi * pi);  // of s (1 + cos pi s)

    static double weight(double s) {
        const double half = std::cos(pi / 2 * s);
        return half * half;  // (1 + cos pi s) / 2, with all digits near the edge
    }
    static Integral integral() { return {pi * ring_integral, pi * ring_integral}; }
    static double cumulative(double s) {
        const double half = std::sin(pi / 2 * s);
        const double ring = s * s / 2 + s * std::sin(pi * s) / pi - 2 * half * half / (pi * pi);
        return ring / ring_integral;
    }
    static double density(double s) { return 2 * s * weight(s) / ring_integral; }
    /// The start follows the series at either end, cumulative(s) = s^2 / ring_integral and
    /// 1 - 5.53 (1 - s)^3, adjusted in the middle; after 4 steps no digit changes.
    static double quantile(double u) {
        if (u <= 0) return 0;
        if (u >= 1) return 1;
        double s = u < 0.5 ? 0.5453 * std::sqrt(u) : 1 - std::cbrt((1 - u) / 5.532);
        for (int step = 0; step < 4; ++step) s -= (cumulative(s) - u) / density(s);
        return s;
    }
};

struct Gaussian {
    static constexpr double exponent = 4.5;  // 1 / (2 sigma^2), sigma = 1/3: edge at 0.011

    static double weight(double s) { return std::exp(-exponent * s * s); }
    static double volume_within(double s) { return -std::expm1(-exponent * s * s); }
    static Integral integral() {
        const double value = pi / exponent * volume_within(1);
        return {value, value};
    }
    static double cumulative(double s) { return volume_within(s) / volume_within(1); }
    static double quantile(double u) {
        return std::sqrt(-std::log1p(-u * volume_within(1)) / exponent);
    }
};

/// Mitchell & Netravali 1988, with B = C = 1/3; their x is 2s here. With x = 2 - v the outer piece
/// is 7/18 v^2 (v - 6/7): negative for x > 8/7.
struct Mitchell {
    static constexpr double zero = 8.0 / 7;                                            // in x
    static constexpr double lobe = 7.0 / 18 * (6.0 / 7) * (6.0 / 7) * (6.0 / 7) / 14;  // its area
    static constexpr double half = 0.5 + 2 * lobe;  // area of the magnitude over x > 0

    static double outer(double v) { return 7.0 / 18 * v * v * (v - 6.0 / 7); }
    static double beyond(double v) { return 7.0 / 18 * v * v * v * (v / 4 - 2.0 / 7); }

    static double weight(double s) {
        const double x = 2 * s;
        if (x < 1) return (x * x * (7 * x - 12) + 16.0 / 3) / 6;
        return outer(2 - x);
    }
    static Integral integral() { return {0.5, half}; }
    static double cumulative(double s) {
        const double x = 2 * s;
        if (x < 1) return x * (x * x * (7.0 / 4 * x - 4) + 16.0 / 3) / 6 / half;
        if (x < zero) return (0.5 - beyond(2 - x)) / half;
        return 1 + beyond(2 - x) / half;
    }
    static double density(double s) { return 2 * std::abs(weight(s)) / half; }
    static double quantile(double u) { return solved<Mitchell>(u); }
};

/// Harris 1978: the window of four terms whose side lobes are 92 dB down.
struct BlackmanHarris {
    static constexpr double a0 = 0.35875, a1 = 0.48829, a2 = 0.14128, a3 = 0.01168;

    static double weight(double s) {
        const double c = std::cos(pi * s);  // cos 2x and cos 3x by it
        return a0 - a2 + c * (a1 - 3 * a3 + c * (2 * a2 + c * 4 * a3));
    }
    static Integral integral() { return {2 * a0, 2 * a0}; }
    static double cumulative(double s) {
        return s + (a1 * std::sin(pi * s) + a2 / 2 * std::sin(2 * pi * s) +
                    a3 / 3 * std::sin(3 * pi * s)) /
                       (pi * a0);
    }
    static double density(double s) { return weight(s) / a0; }
    static double quantile(double u) { return solved<BlackmanHarris>(u); }
};

/// What `ask` says about the shape of this kind.
template <class Ask>
auto of(FilterKind kind, Ask&& ask) {
    switch (kind) {
        case FilterKind::box:
            break;
        case FilterKind::cone:
            return ask(Cone());
        case FilterKind::raised_cosine:
            return ask(RaisedCosine());
        case FilterKind::gaussian:
            return ask(Gaussian());
        case FilterKind::mitchell:
            return ask(Mitchell());
        case FilterKind::blackman_harris:
            return ask(BlackmanHarris());
    }
    return ask(Box());
}

}  // namespace

bool separable(FilterKind kind) {
    return kind == FilterKind::box || kind == FilterKind::mitchell ||
           kind == FilterKind::blackman_harris;
}

double weight(FilterKind kind, double s) {
    return of(kind, [s](auto shape) { return shape.weight(s); });
}

Integral integral(FilterKind kind) {
    return of(kind, [](auto shape) { return shape.integral(); });
}

double cumulative(FilterKind kind, double s) {
    return of(kind, [s](auto shape) { return shape.cumulative(s); });
}

double quantile(FilterKind kind, double u) {
    return of(kind, [u](auto shape) { return shape.quantile(u); });
}

}  // namespace rayshoot::shape
