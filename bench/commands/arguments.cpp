#include "bench/commands/arguments.h"

#include "tracer/image.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <ostream>
#include <stdexcept>

namespace rayshoot {
namespace {

constexpr int most_threads = 1024;

[[noreturn]] void refuse_size(std::string_view text) {
    throw std::invalid_argument("a size reads WIDTHxHEIGHT, 640x480 say, each 1 to " +
                                std::to_string(largest_image) + "; not \"" + std::string(text) +
                                "\"");
}

int side(std::string_view digits, std::string_view text) {
    int value = 0;
    const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (failed != std::errc{} || end != digits.data() + digits.size()) refuse_size(text);
    if (value < 1 || value > largest_image) refuse_size(text);
    return value;
}

void require_affordable(const ImageFormat& format) {
    const auto pixels =
        static_cast<std::size_t>(format.width) * static_cast<std::size_t>(format.height);
    if (pixels <= largest_pixel_count) return;
    throw std::invalid_argument("an image of " + std::to_string(format.width) + " x " +
                                std::to_string(format.height) + " is too large; " +
                                std::to_string(largest_pixel_count) + " pixels are the limit");
}

bool follows_spd_rules(const std::string& scene) {
    const std::string path = scene.substr(0, scene.find(':'));
    return path.starts_with("spd/") || path.starts_with("gallery/") || path.ends_with(".nff") ||
           path.ends_with(".nff.xz") || path.ends_with(".nff.gz");
}

}  // namespace

Size parse_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) refuse_size(text);
    return {side(text.substr(0, cross), text), side(text.substr(cross + 1), text)};
}

ImageFormat image_format(const Scene& scene, const std::string& size, int spp) {
    ImageFormat format = follows_spd_rules(scene.name) ? spd_format : mesh_format;
    if (!size.empty()) {
        const Size given = parse_size(size);
        format.width = given.width;
        format.height = given.height;
    }
    format.spp = spp;
    require_valid(format);
    require_affordable(format);
    return format;
}

ImageFormat stream_format(const std::string& size, int spp) {
    const Size given = parse_size(size);
    const ImageFormat format{given.width, given.height, spp, Raster::centres, 0};
    require_valid(format);
    require_affordable(format);
    return format;
}

void require_takes(const Catalogue& catalogue, const std::string& spec, const Scene& scene) {
    const std::string reason = refusal(catalogue, spec, scene.geometry);
    if (!reason.empty())
        throw std::invalid_argument(spec + " cannot take " + scene.name + ": " + reason);
}

void print_json(std::ostream& out, const nlohmann::ordered_json& document) {
    out << document.dump(2) << '\n';
}

int require_threads(int given) {
    if (given >= 1 && given <= most_threads) return given;
    throw std::invalid_argument("the number of threads must be 1 to " +
                                std::to_string(most_threads) + ", not " + std::to_string(given));
}

}  // namespace rayshoot
