#pragma once

#include <filesystem>

#include "tracer/image.h"

/// The two file formats, each written straight to `path`; use write_image.
namespace rayshoot {

/// Throw std::exception, with the library's reason, when the file cannot be written.
void write_png(const Image& image, const std::filesystem::path& path);
void write_exr(const Image& image, const std::filesystem::path& path);

}  // namespace rayshoot
