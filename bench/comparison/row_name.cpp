#include "bench/comparison/row_name.h"

#include "bench/streams/ray_stream.h"

#include <stdexcept>

namespace rayshoot {
namespace {

bool has_kind(std::string_view family) { return family == "rays" || family == "warm"; }

[[noreturn]] void refuse(std::string_view text) {
    throw std::invalid_argument("\"" + std::string(text) +
                                "\" is no row name; one reads rays/<scene>/<structure>/<ray kind>, "
                                "warm/... likewise, build/<scene>/<structure> or "
                                "render/<scene>/<structure>");
}

/// Cuts off what follows the last slash.
std::string last_part(std::string_view& text, std::string_view whole) {
    const std::size_t slash = text.rfind('/');
    if (slash == std::string_view::npos || slash == 0 || slash + 1 == text.size()) refuse(whole);
    std::string part(text.substr(slash + 1));
    text = text.substr(0, slash);
    return part;
}

}  // namespace

std::string to_string(const RowName& name) {
    const std::string text = name.family + "/" + name.scene + "/" + name.spec;
    return name.kind.empty() ? text : text + "/" + name.kind;
}

bool is_embree(std::string_view spec) { return spec == "embree" || spec.starts_with("embree:"); }

RowName parse_row_name(std::string_view text) {
    RowName name;
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) refuse(text);
    name.family = text.substr(0, slash);
    if (!has_kind(name.family) && name.family != "build" && name.family != "render") refuse(text);
    std::string_view rest = text.substr(slash + 1);
    if (has_kind(name.family)) {
        name.kind = last_part(rest, text);
        static_cast<void>(stream_kind(name.kind));
    }
    name.spec = last_part(rest, text);
    if (rest.empty()) refuse(text);
    name.scene = rest;
    return name;
}

}  // namespace rayshoot
