#pragma once

#include <cstdint>
#include <filesystem>

#include "tracer/image.h"

/// The two file formats, each written straight to `path`; use write_image and read_image.
namespace rayshoot {

/// Throw std::exception, with the library's reason, when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& path);
void write_exr(const Image& image, const std::filesystem::path& path);

/// Throw std::exception, with the library's reason or ours, when there is no image in the file.
Image read_png(const std::filesystem::path& path);
Image read_exr(const std::filesystem::path& path);

/// An image of this size; throws std::invalid_argument when it is empty or too large, before
/// anything is allocated. 64 bits, since a file may claim any 32.
Image image_of_claimed_size(std::int64_t width, std::int64_t height);

}  // namespace rayshoot
