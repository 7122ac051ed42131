#include "tracer/tiles.h"

#include <algorithm>
#include <bit>

namespace rayshoot {
namespace {

/// Appends the cells of the square [x, x + edge) x [y, y + edge) that are inside the raster.
void append_square(int x, int y, int edge, int width, int height, std::vector<Pixel>& order) {
    if (x >= width || y >= height) return;
    if (edge == 1) {
        order.push_back({static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)});
        return;
    }
    const int half = edge / 2;
    append_square(x, y, half, width, height, order);
    append_square(x + half, y, half, width, height, order);
    append_square(x, y + half, half, width, height, order);
    append_square(x + half, y + half, half, width, height, order);
}

}  // namespace

std::vector<Pixel> morton_order(int width, int height) {
    std::vector<Pixel> order;
    order.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto longest = static_cast<unsigned>(std::max(width, height));
    append_square(0, 0, static_cast<int>(std::bit_ceil(longest)), width, height, order);
    return order;
}

Tiles::Tiles(const ImageFormat& format, std::size_t batch, int border)
    : pixels_(morton_order(format.width + 2 * border, format.height + 2 * border)),
      pixels_per_tile_(std::max<std::size_t>(1, batch / static_cast<std::size_t>(format.spp))) {
    for (Pixel& pixel : pixels_) {
        pixel.x = static_cast<std::int16_t>(pixel.x - border);
        pixel.y = static_cast<std::int16_t>(pixel.y - border);
    }
}

std::size_t Tiles::size() const {
    return (pixels_.size() + pixels_per_tile_ - 1) / pixels_per_tile_;
}

std::span<const Pixel> Tiles::tile(std::size_t index) const {
    const std::size_t first = index * pixels_per_tile_;
    return std::span(pixels_).subspan(first, std::min(pixels_per_tile_, pixels_.size() - first));
}

}  // namespace rayshoot
