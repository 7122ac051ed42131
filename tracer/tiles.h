#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "tracer/camera.h"

/// The order in which an image is traced.
namespace rayshoot {

/// Every cell of a width x height raster, along the Z-shaped curve of Morton (1966).
std::vector<Pixel> morton_order(int width, int height);

/// Consecutive pixels of the Morton order, so that a tile's camera rays fill one batch of `batch`
/// rays (several where spp > batch); all samples of a pixel are in one tile. `border`: cells
/// outside the image, on each side, that are pixels, too.
class Tiles {
public:
    Tiles(const ImageFormat& format, std::size_t batch, int border = 0);

    std::size_t size() const;
    std::span<const Pixel> tile(std::size_t index) const;

private:
    std::vector<Pixel> pixels_;
    std::size_t pixels_per_tile_;
};

}  // namespace rayshoot
