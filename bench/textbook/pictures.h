#pragma once

#include "tracer/image.h"
#include "tracer/scalar_image.h"

#include <span>

/// Images put together, cut out and enlarged, for looking at.
namespace rayshoot::textbook {

/// Every pixel as a square of `factor` x `factor`.
Image magnified(const Image& image, int factor);

/// The part from (x, y) on; it lies inside the image.
Image cropped(const Image& image, int x, int y, int width, int height);

/// From left to right in rows of `columns`, a white gap between; all of one size.
Image tiled(std::span<const Image> images, int columns);

/// Values times `factor` as linear greys.
Image greys(const ScalarImage& values, double factor);

}  // namespace rayshoot::textbook
