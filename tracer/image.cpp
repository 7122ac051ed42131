#include "tracer/image.h"

#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "data/digest.h"
#include "tracer/image_file.h"

namespace rayshoot {
namespace {

namespace fs = std::filesystem;

/// One file format.
struct Format {
    void (*write)(const Image&, const fs::path&);
    Image (*read)(const fs::path&);
};

Format format_of(const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".png") return {write_png, read_png};
    if (extension == ".exr") return {write_exr, read_exr};
    throw std::invalid_argument("image '" + path.string() + "': unknown extension '" + extension +
                                "'; .png and .exr are known");
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
    throw std::runtime_error("cannot write image '" + path.string() + "': " + reason);
}

[[noreturn]] void refuse_to_read(const fs::path& path, const std::string& reason) {
    throw std::invalid_argument("cannot read image '" + path.string() + "': " + reason);
}

/// Beside the target, so that the rename stays on one file system.
fs::path partial_path(const fs::path& path) {
    fs::path partial = path;
    partial += ".partial";
    return partial;
}

}  // namespace

std::string digest(const Image& image) {
    Digest sum;
    sum.add(static_cast<std::uint32_t>(image.width()));
    sum.add(static_cast<std::uint32_t>(image.height()));
    for (const vec3& pixel : image.pixels()) {
        for (int channel = 0; channel < 3; ++channel) sum.add(pixel[channel]);
    }
    return sum.hex();
}

void require_writable(const fs::path& path) {
    format_of(path);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) refuse(path, "it is a directory");
    const fs::path partial = partial_path(path);
    if (!std::ofstream(partial, std::ios::binary)) {
        refuse(path, std::system_category().message(errno));
    }
    fs::remove(partial, ignored);
}

void write_image(const Image& image, const fs::path& path) {
    const Format format = format_of(path);
    if (image.pixels().empty()) {
        throw std::invalid_argument("image '" + path.string() + "': there are no pixels to write");
    }
    require_writable(path);
    const fs::path partial = partial_path(path);
    std::error_code ignored;
    try {
        format.write(image, partial);
        fs::rename(partial, path);
    } catch (const std::exception& error) {
        fs::remove(partial, ignored);
        refuse(path, error.what());
    }
}

Image image_of_claimed_size(std::int64_t width, std::int64_t height) {
    // A side at most the whole: their product is then below 2^63.
    constexpr auto most = static_cast<std::int64_t>(largest_pixel_count);
    if (width >= 1 && height >= 1 && width <= most && height <= most && width * height <= most)
        return Image(static_cast<int>(width), static_cast<int>(height));
    throw std::invalid_argument("it claims " + std::to_string(width) + " x " +
                                std::to_string(height) + " pixels; 1 to " + std::to_string(most) +
                                " in all can be read");
}

Image read_image(const fs::path& path) {
    const Format format = format_of(path);
    if (!fs::exists(path)) refuse_to_read(path, "there is no such file");
    if (!fs::is_regular_file(path)) refuse_to_read(path, "it is no regular file");
    if (!std::ifstream(path)) refuse_to_read(path, std::system_category().message(errno));
    try {
        return format.read(path);
    } catch (const std::exception& error) {
        refuse_to_read(path, error.what());
    }
}

}  // namespace rayshoot
