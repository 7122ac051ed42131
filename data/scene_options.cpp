#include "data/scene_options.h"

#include <algorithm>
#include <charconv>
#include <iomanip>
#include <sstream>
#include <stdexcept>

namespace rayshoot {

namespace {

template <class Number>
bool parse(std::string_view text, Number& value) {
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
}

template <class Number>
std::string range(Number lowest, Number highest) {
    std::ostringstream text;
    text << std::setprecision(15) << lowest << " to " << highest;
    return text.str();
}

}  // namespace

SceneOptions::SceneOptions(std::string_view scene, std::string_view text) : scene_(scene) {
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view pair = text.substr(0, comma);
        text.remove_prefix(std::min(comma + 1, text.size()));
        const std::size_t equals = pair.find('=');
        if (equals == std::string_view::npos || equals == 0 || equals + 1 == pair.size())
            throw std::invalid_argument(scene_ + ": option '" + std::string(pair) +
                                        "' is not of the form key=value");
        const std::string_view key = pair.substr(0, equals);
        if (contains(key))
            throw std::invalid_argument(scene_ + ": option '" + std::string(key) +
                                        "' is given twice");
        given_.emplace_back(key, pair.substr(equals + 1));
    }
}

void SceneOptions::require_known(std::span<const std::string_view> keys) const {
    for (const auto& [key, value] : given_) {
        if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
        std::string known;
        for (const std::string_view name : keys) known += ", " + std::string(name);
        throw std::invalid_argument(scene_ + ": unknown option '" + key +
                                    "'; this scene has: precision" + known);
    }
}

int SceneOptions::integer(std::string_view key, int fallback, int lowest, int highest) const {
    const std::string* const given = find(key);
    if (!given) return fallback;
    int value = 0;
    if (!parse(*given, value) || value < lowest || value > highest)
        refuse(key, *given, "a whole number from " + range(lowest, highest));
    return value;
}

double SceneOptions::number(std::string_view key, double fallback, double lowest,
                            double highest) const {
    const std::string* const given = find(key);
    if (!given) return fallback;
    double value = 0;
    if (!parse(*given, value) || !(value >= lowest && value <= highest))
        refuse(key, *given, "a number from " + range(lowest, highest));
    return value;
}

std::string SceneOptions::text(std::string_view key, std::string_view fallback) const {
    const std::string* const given = find(key);
    return given ? *given : std::string(fallback);
}

SceneOptions SceneOptions::without(std::string_view key) const {
    SceneOptions rest = *this;
    std::erase_if(rest.given_, [key](const auto& pair) { return pair.first == key; });
    return rest;
}

const std::string* SceneOptions::find(std::string_view key) const {
    for (const auto& [name, value] : given_)
        if (name == key) return &value;
    return nullptr;
}

void SceneOptions::refuse(std::string_view key, std::string_view value,
                          const std::string& accepted) const {
    throw std::invalid_argument(scene_ + ": " + std::string(key) + "=" + std::string(value) +
                                " is not " + accepted);
}

}  // namespace rayshoot
