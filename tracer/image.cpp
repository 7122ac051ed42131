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

using Writer = void (*)(const Image&, const fs::path&);

Writer writer_for(const fs::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".png") return write_png;
    if (extension == ".exr") return write_exr;
    throw std::invalid_argument("image '" + path.string() + "': unknown extension '" + extension +
                                "'; .png and .exr are known");
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
    throw std::runtime_error("cannot write image '" + path.string() + "': " + reason);
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
    writer_for(path);
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) refuse(path, "it is a directory");
    const fs::path partial = partial_path(path);
    if (!std::ofstream(partial, std::ios::binary)) {
        refuse(path, std::system_category().message(errno));
    }
    fs::remove(partial, ignored);
}

void write_image(const Image& image, const fs::path& path) {
    const Writer write = writer_for(path);
    if (image.pixels().empty()) {
        throw std::invalid_argument("image '" + path.string() + "': there are no pixels to write");
    }
    require_writable(path);
    const fs::path partial = partial_path(path);
    std::error_code ignored;
    try {
        write(image, partial);
        fs::rename(partial, path);
    } catch (const std::exception& error) {
        fs::remove(partial, ignored);
        refuse(path, error.what());
    }
}

}  // namespace rayshoot
