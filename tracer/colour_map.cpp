#include "tracer/colour_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayshoot {
namespace {

/// The ends of the helix. With these every colour is inside sRGB (the test asks), which is what
/// bounds the chroma: blue-green has the least to give.
constexpr double dark = 0.24, light = 0.93;           // OKLab lightness
constexpr double violet_hue = 308, yellow_hue = 100;  // degrees; by way of blue and green
constexpr double chroma = 0.094;
const vec3 not_a_number(0.25f);

/// Ottosson, "A perceptual color space for image processing", 2020: OKLab to linear sRGB.
vec3 linear_rgb(double lightness, double a, double b) {
    const auto cubed = [](double x) { return x * x * x; };
    const double l = cubed(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cubed(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cubed(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return dvec3(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                 -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                 -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s);
}

double spread(double value, Spacing spacing) {
    return spacing == Spacing::linear ? value : std::log1p(value);
}

}  // namespace

vec3 map_colour(double place) {
    if (std::isnan(place)) return not_a_number;
    const double along = std::clamp(place, 0.0, 1.0);
    const double hue = std::lerp(violet_hue, yellow_hue, along) * (std::numbers::pi / 180);
    return linear_rgb(std::lerp(dark, light, along), chroma * std::cos(hue),
                      chroma * std::sin(hue));
}

double ColourScale::place(double value) const {
    const double from = spread(low, spacing), to = spread(high, spacing);
    return to > from           ? (spread(value, spacing) - from) / (to - from)
           : std::isnan(value) ? value
                               : 0;
}

double ColourScale::value(double place) const {
    const double spread_value = std::lerp(spread(low, spacing), spread(high, spacing), place);
    return spacing == Spacing::linear ? spread_value : std::expm1(spread_value);
}

ColourScale common_scale(std::span<const ScalarImage> images, Spacing spacing) {
    ColourScale scale{0, 0, spacing};
    for (const ScalarImage& image : images) {
        for (const double value : image.values()) {
            if (std::isfinite(value)) scale.high = std::max(scale.high, value);
        }
    }
    return scale;
}

Image coloured(const ScalarImage& values, const ColourScale& scale) {
    Image image(values.width(), values.height());
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x) {
            image.at(x, y) = map_colour(scale.place(values.at(x, y)));
        }
    }
    return image;
}

Image grey(const ScalarImage& values) {
    Image image(values.width(), values.height());
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x) {
            image.at(x, y) = vec3(static_cast<float>(values.at(x, y)));
        }
    }
    return image;
}

}  // namespace rayshoot
