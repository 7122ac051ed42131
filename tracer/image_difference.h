#pragma once

#include <cstddef>

#include "tracer/camera.h"
#include "tracer/image.h"
#include "tracer/scalar_image.h"

/// How far two images of one size are apart, in linear RGB.
namespace rayshoot {

struct ImageDifference {
    std::size_t pixels = 0;
    std::size_t differing = 0;     ///< pixels of which a channel differs by more than the tolerance
    std::size_t incomparable = 0;  ///< of those: where a channel is a number in one image only
    double largest = 0;            ///< over all channels that can be compared
    Pixel largest_at;              ///< the first, row by row, with that difference
    double rms = 0;                ///< root mean square over all channels that can be compared

    bool agree() const { return differing == 0; }
};

/// `tolerance`: how far a channel may be apart, 0 or more. Numbers are compared as numbers (-0 is
/// 0); NaN agrees with NaN, an infinity with itself. Throws std::invalid_argument for images of
/// different sizes.
ImageDifference compare_images(const Image& a, const Image& b, double tolerance = 0);

/// Of each pixel the largest |a - b| of its channels; NaN where they cannot be compared.
ScalarImage difference_map(const Image& a, const Image& b);

/// a - b, channel by channel.
Image signed_difference(const Image& a, const Image& b);

}  // namespace rayshoot
