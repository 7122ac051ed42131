#include "bench/textbook/pictures.h"

#include "tracer/colour_map.h"

namespace rayshoot::textbook {
namespace {

constexpr int gap = 4;  // pixels

void paste(const Image& from, Image& to, int left, int top) {
    for (int y = 0; y < from.height(); ++y) {
        for (int x = 0; x < from.width(); ++x) to.at(left + x, top + y) = from.at(x, y);
    }
}

}  // namespace

Image magnified(const Image& image, int factor) {
    Image result(image.width() * factor, image.height() * factor);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) {
            result.at(x, y) = image.at(x / factor, y / factor);
        }
    }
    return result;
}

Image cropped(const Image& image, int x, int y, int width, int height) {
    Image result(width, height);
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            result.at(column, row) = image.at(x + column, y + row);
        }
    }
    return result;
}

Image tiled(std::span<const Image> images, int columns) {
    const int count = static_cast<int>(images.size());
    const int rows = (count + columns - 1) / columns;
    const int width = images.front().width(), height = images.front().height();
    Image result(columns * (width + gap) - gap, rows * (height + gap) - gap);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) result.at(x, y) = vec3(1);
    }
    for (int i = 0; i < count; ++i) {
        paste(images[static_cast<std::size_t>(i)], result, i % columns * (width + gap),
              i / columns * (height + gap));
    }
    return result;
}

Image greys(const ScalarImage& values, double factor) {
    Image image = grey(values);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) image.at(x, y) *= static_cast<float>(factor);
    }
    return image;
}

}  // namespace rayshoot::textbook
