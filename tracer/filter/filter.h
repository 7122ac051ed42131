#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tracer/sampling/pair.h"

/// The weight with which the light around the middle of a pixel enters the pixel. Lengths are in
/// pixels. README.md has the formulas and their sources.
namespace rayshoot {

/// Separable ones have a square for support, the others a disc.
enum class FilterKind : std::uint8_t {
    box,              ///< separable: 1
    cone,             ///< 1 - r / R
    raised_cosine,    ///< (1 + cos(pi r / R)) / 2: the window of von Hann. The textbook calls it
                      ///< "Hamming", whose window is 0.54 + 0.46 cos and steps at the edge
    gaussian,         ///< exp(-r^2 / (2 sigma^2)) with sigma = R / 3, cut off at R
    mitchell,         ///< separable, B = C = 1/3 stretched to R; falls below 0 from 4R/7 on
    blackman_harris,  ///< separable: the window of four terms
};
inline constexpr std::array<std::string_view, 6> filter_names{
    "box", "cone", "hann", "gaussian", "mitchell", "blackman_harris"};

std::string_view name(FilterKind kind);
/// By its name; "hamming", the textbook's name for it, is "hann". Throws std::invalid_argument,
/// listing the names, for another one.
FilterKind filter_kind(std::string_view name);

/// Below it pixels would be left without a sample; of a box, whole pixels.
inline constexpr double smallest_radius = 0.5;
inline constexpr double largest_radius = 16;

struct FilterSettings {
    FilterKind kind = FilterKind::box;
    double radius = 0.5;  ///< R: of a disc its radius, of a square half its edge
};

class Filter {
public:
    /// Throws std::invalid_argument for a radius out of [smallest_radius, largest_radius].
    explicit Filter(const FilterSettings& settings = {});

    /// The weight at (x, y) from the middle of the pixel. 1 at (0, 0), where Mitchell's is 64/81;
    /// 0 off the support, which is half open: [-R, R) x [-R, R), or r < R.
    double operator()(double x, double y) const;
    /// Over the plane; in closed form.
    double integral() const { return integral_; }
    /// Beyond it, in x or in y, the weight is 0.
    double reach() const { return settings_.radius; }
    bool separable() const;
    /// Whether weights are negative anywhere.
    bool negative_lobes() const { return settings_.kind == FilterKind::mitchell; }
    /// The weight along a line through the middle: w(x, y) = profile(x) profile(y) where separable,
    /// else profile(r).
    double profile(double distance) const;
    const FilterSettings& settings() const { return settings_; }

    /// A place to look at, from the middle of the pixel, and how much it counts: the mean of
    /// weight * light over uniform pairs is the filtered light.
    struct Offset {
        double x = 0, y = 0, weight = 1;
    };
    /// Importance sampling: (x, y) is distributed as |w|. The weight is exactly 1, but with
    /// negative lobes the sign of w times integral of |w| / integral of w. On a disc u goes with
    /// the radius and v with the azimuth, counted from the x axis; on a square u with x, v with y:
    /// so strata of pairs are regions of equal volume (regions.h).
    Offset importance(Pair pair) const {
        const double radius = settings_.radius;
        if (settings_.kind != FilterKind::box) return by_quantiles(pair);
        return {radius * (2.0 * pair.u - 1), radius * (2.0 * pair.v - 1), 1};  // it is uniform
    }
    /// Uniform over the support, u and v as above: strata of pairs are regions of equal area. The
    /// weight is w * area of the support / integral of w.
    Offset uniform(Pair pair) const;

private:
    Offset by_quantiles(Pair pair) const;

    FilterSettings settings_;
    double integral_, of_magnitude_;  ///< of w and of |w|
};

}  // namespace rayshoot
