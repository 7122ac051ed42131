#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The options of a scene string: what follows the colon in
/// `spd/tetra:size=8,precision=watertight`.
namespace rayshoot {

class SceneOptions {
public:
    SceneOptions() = default;
    /// `scene`: the part before the colon, named in errors. `text`: key=value pairs, may be empty.
    /// Throws std::invalid_argument for a pair without '=', an empty key or value, a repeated key.
    SceneOptions(std::string_view scene, std::string_view text);

    /// Throws std::invalid_argument, listing `keys`, when any other key was given.
    void require_known(std::span<const std::string_view> keys) const;
    void require_known(std::initializer_list<std::string_view> keys) const {
        require_known(std::span(keys.begin(), keys.size()));
    }

    /// The value given, or the fallback. Each throws std::invalid_argument with the key, the value
    /// and what would be accepted; the range is closed.
    int integer(std::string_view key, int fallback, int lowest, int highest) const;
    double number(std::string_view key, double fallback, double lowest, double highest) const;
    std::string text(std::string_view key, std::string_view fallback) const;

    bool contains(std::string_view key) const { return find(key) != nullptr; }
    bool empty() const { return given_.empty(); }
    /// The same options but for `key`.
    SceneOptions without(std::string_view key) const;

private:
    const std::string* find(std::string_view key) const;
    [[noreturn]] void refuse(std::string_view key, std::string_view value,
                             const std::string& accepted) const;

    std::string scene_;
    std::vector<std::pair<std::string, std::string>> given_;
};

}  // namespace rayshoot
