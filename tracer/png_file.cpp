#include <png.h>

#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "tracer/image_file.h"

namespace rayshoot {
namespace {

/// IEC 61966-2-1, the sRGB transfer curve.
std::uint8_t encoded(float linear) {
    if (!(linear > 0)) return 0;  // NaN too
    if (linear >= 1) return 255;
    const double value = linear;
    const double curved =
        value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * curved));
}

std::vector<std::uint8_t> encoded(const Image& image) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(image.pixels().size() * 3);
    for (const vec3& pixel : image.pixels()) {
        for (int channel = 0; channel < 3; ++channel) bytes.push_back(encoded(pixel[channel]));
    }
    return bytes;
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void write_png(const Image& image, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = encoded(image);
    std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "wb"));
    if (!file) throw std::system_error(errno, std::system_category());

    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = static_cast<png_uint_32>(image.width());
    header.height = static_cast<png_uint_32>(image.height());
    header.format = PNG_FORMAT_RGB;
    constexpr int full_range = 0;   // bytes are sRGB already
    constexpr int packed_rows = 0;  // row stride: width * 3
    if (!png_image_write_to_stdio(&header, file.get(), full_range, bytes.data(), packed_rows,
                                  nullptr)) {
        throw std::runtime_error(header.message);
    }
    if (std::fclose(file.release()) != 0) throw std::system_error(errno, std::system_category());
}

}  // namespace rayshoot
