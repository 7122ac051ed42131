#include "bench/streams/ray_file.h"

#include "bench/output/whole_file.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace rayshoot {
namespace {

constexpr std::size_t header_bytes = 56;
constexpr std::size_t ray_bytes = 36;
constexpr std::size_t source_bytes = 4;
constexpr std::uint32_t longest_scene = 4096;  // bytes; a scene string is a line, not a text
constexpr std::uint32_t most_kinds = stream_kind_names.size() - 1;
constexpr std::uint32_t with_sources = 1;  // the only flag

class Writer {
public:
    void number(std::uint64_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xff);
    }
    void number(std::uint32_t value) { number(value, 4); }
    void real(float value) { number(std::bit_cast<std::uint32_t>(value)); }
    void vector(const vec3& value) {
        for (int axis = 0; axis < 3; ++axis) real(value[axis]);
    }
    void text(std::string_view value) { bytes_ += value; }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

class Reader {
public:
    Reader(const std::filesystem::path& path, std::string bytes)
        : path_(path.string()), bytes_(std::move(bytes)) {}

    std::uint64_t number(int count) {
        std::uint64_t value = 0;
        for (int i = 0; i < count; ++i) {
            value |= std::uint64_t{static_cast<unsigned char>(bytes_[at_++])} << (8 * i);
        }
        return value;
    }
    std::uint32_t number() { return static_cast<std::uint32_t>(number(4)); }
    float real() { return std::bit_cast<float>(number()); }
    vec3 vector() {
        const float x = real(), y = real(), z = real();
        return {x, y, z};
    }
    std::string text(std::size_t length) {
        at_ += length;
        return bytes_.substr(at_ - length, length);
    }
    /// A number that must lie in [lowest, highest].
    std::uint32_t number(const std::string& what, std::uint32_t lowest, std::uint32_t highest) {
        const std::uint32_t value = number();
        if (value >= lowest && value <= highest) return value;
        refuse(at_ - 4, what + " is " + std::to_string(value) + ", not " + std::to_string(lowest) +
                            " to " + std::to_string(highest));
    }
    std::size_t left() const { return bytes_.size() - at_; }
    std::size_t at() const { return at_; }
    [[noreturn]] void refuse(std::size_t offset, const std::string& reason) const {
        throw std::runtime_error(path_ + ": byte " + std::to_string(offset) + ": " + reason +
                                 "; `rayshoot rays` writes files that can be read");
    }

private:
    std::string path_;
    std::string bytes_;
    std::size_t at_ = 0;
};

void write_header(Writer& out, const RayStream& stream) {
    out.text(ray_file_magic);
    out.number(ray_file_version);
    out.number(static_cast<std::uint32_t>(stream.kind));
    out.number(static_cast<std::uint32_t>(stream.batch_kind));
    out.number(static_cast<std::uint32_t>(stream.question));
    out.number(stream.depth);
    out.number(static_cast<std::uint32_t>(stream.width));
    out.number(static_cast<std::uint32_t>(stream.height));
    out.number(static_cast<std::uint32_t>(stream.samples));
    out.number(stream.sources.empty() ? 0 : with_sources);
    out.number(static_cast<std::uint32_t>(stream.scene.size()));
    out.number(stream.rays.size(), 8);
    out.text(stream.scene);
}

void require_magic(Reader& in) {
    if (in.left() < header_bytes) in.refuse(0, "no ray file: shorter than its header");
    if (in.text(ray_file_magic.size()) != ray_file_magic) {
        in.refuse(0, "no ray file: it does not begin with RAYSHOOT");
    }
    const std::uint32_t version = in.number();
    if (version != ray_file_version) {
        in.refuse(8, "version " + std::to_string(version) + ", of which this program knows only " +
                         std::to_string(ray_file_version));
    }
}

struct Layout {
    std::uint64_t rays;
    bool sources;
};

/// Everything before the rays; the sizes it declares are those of the file when it returns.
Layout read_header(Reader& in, RayStream& stream) {
    require_magic(in);
    stream.kind = static_cast<StreamKind>(in.number("stream kind", 0, most_kinds));
    stream.batch_kind = static_cast<RayKind>(in.number("batch kind", 0, ray_kinds - 1));
    stream.question = static_cast<Query>(in.number("question", 0, 1));
    stream.depth = static_cast<std::uint8_t>(in.number("depth", 1, 255));
    constexpr std::uint32_t most_cells = std::numeric_limits<std::int16_t>::max();
    stream.width = static_cast<int>(in.number("image width", 0, most_cells));
    stream.height = static_cast<int>(in.number("image height", 0, most_cells));
    stream.samples = static_cast<int>(in.number("samples per pixel", 0, 1u << 20));
    const bool sources = in.number("flags", 0, with_sources) == with_sources;
    const std::uint32_t scene_bytes = in.number("length of the scene string", 0, longest_scene);
    const std::size_t count_at = in.at();
    const std::uint64_t count = in.number(8);
    const std::uint64_t each = ray_bytes + (sources ? source_bytes : 0);
    const std::uint64_t left = in.left();
    if (left < scene_bytes || count > left / each || left - scene_bytes != count * each) {
        in.refuse(count_at, "declares " + std::to_string(count) +
                                " rays, which is not what the size of the file bears out");
    }
    stream.scene = in.text(scene_bytes);
    return {count, sources};
}

Ray read_ray(Reader& in) {
    Ray ray;
    ray.origin = in.vector();
    ray.t_min = in.real();
    ray.direction = in.vector();
    ray.t_max = in.real();
    ray.time = in.real();
    return ray;
}

std::string whole_contents(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw std::runtime_error(path.string() +
                                 ": no such file; `rayshoot rays --out` writes one");
    }
    std::ifstream in(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    if (!in) throw std::runtime_error(path.string() + ": cannot be read");
    return bytes;
}

}  // namespace

void write_ray_file(const std::filesystem::path& path, const RayStream& stream) {
    Writer out;
    write_header(out, stream);
    for (const Ray& ray : stream.rays) {
        out.vector(ray.origin);
        out.real(ray.t_min);
        out.vector(ray.direction);
        out.real(ray.t_max);
        out.real(ray.time);
    }
    for (const Source source : stream.sources) out.number(source.bits);
    write_whole_file(path, out.bytes());
}

RayStream read_ray_file(const std::filesystem::path& path) {
    Reader in(path, whole_contents(path));
    RayStream stream;
    const Layout layout = read_header(in, stream);
    stream.rays.reserve(layout.rays);
    for (std::uint64_t i = 0; i < layout.rays; ++i) stream.rays.push_back(read_ray(in));
    if (layout.sources) {
        for (std::uint64_t i = 0; i < layout.rays; ++i) stream.sources.push_back({in.number()});
    }
    return stream;
}

}  // namespace rayshoot
