#pragma once

#include "accel/core/catalogue.h"

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The options of one structure in a spec: key=value pairs against the list it declares.
namespace rayshoot::inline RAYSHOOT_ISA {

class Options {
public:
    /// `text`: what follows the name and its colon ("density=3,mailbox=on"), may be empty.
    /// Throws std::invalid_argument, listing what exists, for an unknown or repeated key, or no
    /// '='.
    Options(std::string_view structure, std::span<const OptionInfo> known, std::string_view text);

    /// The value given, or the declared fallback. Each throws std::invalid_argument with the key,
    /// the value and what would be accepted. Asking for a key that is not declared is a
    /// logic_error.
    double number(std::string_view key, double lowest, double highest) const;
    int integer(std::string_view key, int lowest, int highest) const;
    bool flag(std::string_view key) const;  ///< on|off
    std::string_view text(std::string_view key) const;

    /// One of several named values: options.choice("kernel", {{"single", Kernel::single}, ...}).
    template <class Value>
    Value choice(std::string_view key,
                 std::initializer_list<std::pair<std::string_view, Value>> values) const {
        const std::string_view given = text(key);
        std::string names;
        for (const auto& [name, value] : values) {
            if (name == given) return value;
            names += names.empty() ? std::string(name) : ", " + std::string(name);
        }
        refuse(key, "one of " + names);
    }

    /// True when no option was given.
    bool empty() const { return given_.empty(); }
    /// "name" or "name:key=value,...": what was given, in the declared order.
    std::string canonical() const;

private:
    [[noreturn]] void refuse(std::string_view key, const std::string& accepted) const;

    std::string structure_;
    std::span<const OptionInfo> known_;
    std::vector<std::pair<std::string, std::string>> given_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
