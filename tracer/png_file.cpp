#include <png.h>

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
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

/// Its inverse, for each byte.
std::array<float, 256> decoding_table() {
    std::array<float, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte) {
        const double value = static_cast<double>(byte) / 255;
        table[byte] = static_cast<float>(value <= 0.04045 ? value / 12.92
                                                          : std::pow((value + 0.055) / 1.055, 2.4));
    }
    return table;
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

using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

OpenFile opened(const std::filesystem::path& path, const char* mode) {
    OpenFile file(std::fopen(path.c_str(), mode));
    if (!file) throw std::system_error(errno, std::system_category());
    return file;
}

/// libpng's simplified reader; it must be freed when it was not read to the end.
struct PngReader {
    png_image header{};
    PngReader() { header.version = PNG_IMAGE_VERSION; }
    ~PngReader() { png_image_free(&header); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    void require(bool succeeded) const {
        if (!succeeded || PNG_IMAGE_FAILED(header)) throw std::runtime_error(header.message);
    }
};

/// A lie about the size costs no memory: deflate (RFC 1951) shrinks at most 1032-fold, and a pixel
/// has a bit at least.
void require_plausible(const png_image& header, std::uintmax_t file_bytes) {
    constexpr std::uintmax_t most_pixels_per_byte = 1032 * 8;
    if (std::uintmax_t{header.width} * header.height <= file_bytes * most_pixels_per_byte) return;
    throw std::invalid_argument("a file of " + std::to_string(file_bytes) + " bytes cannot hold " +
                                std::to_string(header.width) + " x " +
                                std::to_string(header.height) + " pixels; it is broken off");
}

void require_eight_bit_colour(const png_image& header) {
    if (header.format & PNG_FORMAT_FLAG_LINEAR)
        throw std::invalid_argument("it has 16 bits a channel; give 8 bits, or an .exr");
    if (header.format & PNG_FORMAT_FLAG_ALPHA)
        throw std::invalid_argument("it is transparent in places; flatten it first");
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
    const OpenFile file = opened(path, "rb");
    PngReader reader;
    reader.require(png_image_begin_read_from_stdio(&reader.header, file.get()));
    require_eight_bit_colour(reader.header);
    require_plausible(reader.header, std::filesystem::file_size(path));
    Image image = image_of_claimed_size(reader.header.width, reader.header.height);
    reader.header.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(reader.header));
    constexpr int packed_rows = 0;
    reader.require(
        png_image_finish_read(&reader.header, nullptr, bytes.data(), packed_rows, nullptr));
    const std::array<float, 256> decoded = decoding_table();
    auto byte = bytes.begin();
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int channel = 0; channel < 3; ++channel)
                image.at(x, y)[channel] = decoded[*byte++];
        }
    }
    return image;
}

void write_png(const Image& image, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = encoded(image);
    OpenFile file = opened(path, "wb");
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
