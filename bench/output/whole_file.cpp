#include "bench/output/whole_file.h"

#include <unistd.h>

#include <fstream>
#include <stdexcept>
#include <string>

namespace rayshoot {
namespace {

std::filesystem::path folder_of(const std::filesystem::path& path) {
    return path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
}

}  // namespace

void require_writable_file(const std::filesystem::path& path) {
    const std::string name = path.string();
    if (name.empty()) throw std::invalid_argument("an output file needs a name, not \"\"");
    if (std::filesystem::is_directory(path)) {
        throw std::invalid_argument(name + ": is a directory; name a file in it");
    }
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
        throw std::invalid_argument(name + ": is no regular file, and would be replaced by one");
    }
    const std::filesystem::path folder = folder_of(path);
    if (!std::filesystem::is_directory(folder)) {
        throw std::invalid_argument(name + ": the directory " + folder.string() +
                                    " does not exist; create it first");
    }
    if (access(folder.c_str(), W_OK) != 0) {
        throw std::invalid_argument(name + ": the directory " + folder.string() +
                                    " cannot be written to");
    }
}

void write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
    require_writable_file(path);
    std::filesystem::path part = path;
    part += ".part";
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    std::error_code failed;
    if (out) std::filesystem::rename(part, path, failed);
    if (!out || failed) {
        std::filesystem::remove(part, failed);
        throw std::runtime_error(path.string() + ": cannot be written; is the disk full?");
    }
}

}  // namespace rayshoot
