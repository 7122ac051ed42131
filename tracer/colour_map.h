#pragma once

#include <cstdint>
#include <span>

#include "tracer/image.h"
#include "tracer/scalar_image.h"

/// Numbers as colours: a perceptual colour map, and one scale for images that are compared.
namespace rayshoot {

/// Linear RGB of a place on the map, 0 (dark violet) to 1 (light yellow); beyond the ends, the
/// end's. A helix in OKLab (Ottosson 2020): lightness and hue go linearly, the chroma stays, so
/// equal steps of `place` look equally far apart, and the map still rises in shades of grey. NaN:
/// grey.
vec3 map_colour(double place);

/// What is spread evenly over the map: the values, or the logarithms of 1 + value.
enum class Spacing : std::uint8_t { linear, logarithmic };

/// From values to places on the map.
struct ColourScale {
    double low = 0, high = 1;  ///< the values at places 0 and 1
    Spacing spacing = Spacing::linear;

    /// 0 for a scale of no length.
    double place(double value) const;
    /// The value at a place: the inverse of `place`.
    double value(double place) const;
};

/// From 0 to the largest finite value of all images, so that equal colours are equal numbers.
ColourScale common_scale(std::span<const ScalarImage> images, Spacing spacing);

Image coloured(const ScalarImage& values, const ColourScale& scale);

/// The same number in every channel, rounded to float: for .exr files of raw values.
Image grey(const ScalarImage& values);

}  // namespace rayshoot
