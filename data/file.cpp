#include "data/file.h"

#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filter/lzma.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

namespace rayshoot {

namespace {

// A text mesh packs 3 to 30 times; only a file made to fill the memory goes far beyond.
constexpr std::uintmax_t largest_packing = 200;         // unpacked bytes per byte
constexpr std::uintmax_t always_allowed = 64ull << 20;  // bytes
constexpr std::uintmax_t largest_file = 8ull << 30;     // bytes

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason) {
    throw std::invalid_argument(path.string() + ": " + reason);
}

std::uintmax_t size_of_regular_file(const std::filesystem::path& path) {
    if (path.empty()) throw std::invalid_argument("the path of the scene is empty; give a file");
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) refuse(path, "there is no such file");
    if (std::filesystem::is_directory(status)) refuse(path, "is a directory; give one file in it");
    if (!std::filesystem::is_regular_file(status))
        refuse(path, "is not a regular file; copy what it delivers into one");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    if (error) refuse(path, "cannot be read: " + error.message());
    if (size > largest_file) refuse(path, "has more than 8 GiB; split or simplify the scene");
    return size;
}

std::string read_all(std::istream& in, std::uintmax_t limit, const std::filesystem::path& path) {
    std::string text;
    std::array<char, 1 << 16> buffer;
    while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0) {
        text.append(buffer.data(), static_cast<std::size_t>(in.gcount()));
        if (text.size() > limit)
            refuse(path, "unpacks to more than " + std::to_string(limit >> 20) +
                             " MiB; unpack it by hand if that is what it should hold");
    }
    return text;
}

template <class Filter>
std::string unpack(std::istream& file, const Filter& filter, std::uintmax_t size,
                   const std::filesystem::path& path) try {
    boost::iostreams::filtering_istream in;
    in.push(filter);
    in.push(file);
    in.exceptions(std::ios::badbit);
    return read_all(in, std::max(always_allowed, size * largest_packing), path);
} catch (const std::ios_base::failure&) {  // the base of Boost's gzip_error and lzma_error
    refuse(path, "is damaged: it does not unpack; fetch or copy it again");
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
    const std::uintmax_t size = size_of_regular_file(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse(path, "cannot be opened; check its permissions");
    const std::string packer = path.extension().string();
    if (packer == ".xz") return unpack(file, boost::iostreams::lzma_decompressor(), size, path);
    if (packer == ".gz") return unpack(file, boost::iostreams::gzip_decompressor(), size, path);
    std::string text(size, '\0');
    file.read(text.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size) refuse(path, "ends early");
    return text;
}

std::string format_of(const std::filesystem::path& path) {
    const std::string packer = path.extension().string();
    std::string format =
        packer == ".xz" || packer == ".gz" ? path.stem().extension().string() : packer;
    std::ranges::transform(format, format.begin(), [](char c) {
        return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return format;
}

}  // namespace rayshoot
