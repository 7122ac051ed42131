#pragma once

#include <string>
#include <string_view>

/// A row's name is a command: `rays/spd/gears/vista_buffer+bvh/camera` parses back and reruns
/// alone.
namespace rayshoot {

struct RowName {
    std::string family;  ///< rays: fresh sessions; warm: sessions kept; build; render
    std::string scene;   ///< may hold slashes
    std::string spec;
    std::string kind;  ///< of the rays; empty in families build and render

    bool operator==(const RowName&) const = default;
};

std::string to_string(const RowName& name);

/// Whether a spec is Embree's, with whatever options.
bool is_embree(std::string_view spec);

/// Throws std::invalid_argument, showing the form, for anything else.
RowName parse_row_name(std::string_view text);

}  // namespace rayshoot
