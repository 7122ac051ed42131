#include "accel/core/options.h"

#include <charconv>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

std::string listed(std::span<const OptionInfo> known) {
    if (known.empty()) return "it has none";
    std::string names;
    for (const OptionInfo& option : known) {
        names += names.empty() ? "it has " : ", ";
        names += std::string(option.name) + "=" + std::string(option.values);
    }
    return names;
}

}  // namespace

Options::Options(std::string_view structure, std::span<const OptionInfo> known,
                 std::string_view text)
    : structure_(structure), known_(known) {
    while (!text.empty()) {
        const std::string_view pair = text.substr(0, text.find(','));
        const bool last = pair.size() == text.size();
        text.remove_prefix(last ? pair.size() : pair.size() + 1);
        const std::size_t equals = pair.find('=');
        const std::string key(pair.substr(0, equals));
        const std::string complaint =
            "structure " + structure_ + ": option '" + std::string(pair) + "' ";
        if (equals == std::string_view::npos || equals + 1 == pair.size() ||
            (!last && text.empty()))
            throw std::invalid_argument(complaint + "is not key=value");
        if (std::none_of(known.begin(), known.end(),
                         [&](const OptionInfo& o) { return o.name == key; }))
            throw std::invalid_argument(complaint + "is unknown; " + listed(known));
        for (const auto& [earlier, value] : given_)
            if (earlier == key) throw std::invalid_argument(complaint + "is given twice");
        given_.emplace_back(key, std::string(pair.substr(equals + 1)));
    }
}

std::string_view Options::text(std::string_view key) const {
    for (const auto& [name, value] : given_)
        if (name == key) return value;
    for (const OptionInfo& option : known_)
        if (option.name == key) return option.fallback;
    throw std::logic_error("structure " + structure_ + " asks for option '" + std::string(key) +
                           "', which it does not declare");
}

double Options::number(std::string_view key, double lowest, double highest) const {
    const std::string_view given = text(key);
    double value = 0;
    const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
    if (error != std::errc() || end != given.data() + given.size() || !(value >= lowest) ||
        !(value <= highest))
        refuse(key, "a number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return value;
}

int Options::integer(std::string_view key, int lowest, int highest) const {
    const std::string_view given = text(key);
    int value = 0;
    const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
    if (error != std::errc() || end != given.data() + given.size() || value < lowest ||
        value > highest)
        refuse(key,
               "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    return value;
}

bool Options::flag(std::string_view key) const {
    return choice<bool>(key, {{"on", true}, {"off", false}});
}

std::string Options::canonical() const {
    std::string spec = structure_;
    char separator = ':';
    for (const OptionInfo& option : known_)
        for (const auto& [name, value] : given_)
            if (name == option.name) {
                spec += separator + name + "=" + value;
                separator = ',';
            }
    return spec;
}

void Options::refuse(std::string_view key, const std::string& accepted) const {
    throw std::invalid_argument("structure " + structure_ + ": option " + std::string(key) + "=" +
                                std::string(text(key)) + " should be " + accepted);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
