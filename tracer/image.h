#pragma once

#include "accel/core/vec.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// A float image and the files it goes into.
namespace rayshoot {

/// Linear RGB, row by row from the top left.
class Image {
public:
    Image() = default;
    Image(int width, int height)
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), vec3(0)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    const vec3& at(int x, int y) const { return pixels_[index(x, y)]; }
    vec3& at(int x, int y) { return pixels_[index(x, y)]; }
    const std::vector<vec3>& pixels() const { return pixels_; }
    bool operator==(const Image&) const = default;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }
    int width_ = 0, height_ = 0;
    std::vector<vec3> pixels_;
};

/// SHA-256 (hex) of width, height and the floats' bits: equal iff the images are, bit for bit.
std::string digest(const Image& image);

/// The format by the extension: .png (8 bits a channel, sRGB, clipped to [0, 1]) or .exr (32-bit
/// float, linear). The file appears whole or not at all. Throws std::invalid_argument for another
/// extension or an empty image, std::runtime_error, naming the file, when it cannot be written.
void write_image(const Image& image, const std::filesystem::path& path);

/// What read_image takes: 800 MB of floats.
inline constexpr std::size_t largest_pixel_count = std::size_t{1} << 26;

/// An image from a file, linear RGB. .png: 8 bits a channel, colours, greys or a palette, decoded
/// from sRGB, so that write_image gives the same bytes again; neither 16 bits nor transparency.
/// .exr: the channels R, G and B of one flat part, whatever else there is. Throws
/// std::invalid_argument, naming the file and the remedy, for another extension, a file that is not
/// there, broken off or of another type, and for more than largest_pixel_count pixels.
Image read_image(const std::filesystem::path& path);

/// Throws what write_image would throw for this path, as far as that shows before rendering.
void require_writable(const std::filesystem::path& path);

}  // namespace rayshoot
