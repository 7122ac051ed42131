#pragma once

#include "tracer/filter/filter.h"
#include "tracer/scalar_image.h"

#include <functional>

/// Functions of the plane as images: sampled at the middles of pixels, and averaged under a filter.
namespace rayshoot::textbook {

/// Of a raster point, in pixels; the middle of pixel (i, j) is (i + 1/2, j + 1/2).
using Signal = std::function<double(double x, double y)>;

ScalarImage point_sampled(const Signal& signal, int width, int height);

/// The mean of the signal round each pixel's middle, weighted by the filter: over a lattice of
/// `subdivisions` x `subdivisions` points a pixel, so that nothing is left to chance.
/// `subdivisions` is even, and resolves the signal.
ScalarImage filtered(const Signal& signal, const Filter& filter, int width, int height,
                     int subdivisions);

/// What the filter makes of a wave of so many cycles a pixel along x and y: the factor of its
/// amplitude, which is the filter's Fourier transform, 1 at no frequency. On a disc the Hankel
/// transform of the profile, on a square the product of two cosine transforms (Bracewell 1965).
double response(const Filter& filter, double along_x, double along_y);

}  // namespace rayshoot::textbook
