#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What hangs in the gallery: every effect of the tracer as a picture that one command renders.
namespace rayshoot::gallery {

struct Exhibit {
    std::string_view effect;    ///< what it shows; neighbours of one effect hang side by side
    std::string_view name;      ///< of its file, without .png
    std::string_view scene;     ///< as load_scene takes it
    std::string_view size;      ///< WxH of a frame
    std::string_view settings;  ///< as apply_settings takes them
    std::string_view caption;
    int frames = 1;  ///< of an animation, laid out in rows
};

/// Neighbours of one effect in a row.
std::span<const Exhibit> exhibits();

/// By their names; all of them for none. Throws std::invalid_argument, listing what there is.
std::vector<Exhibit> chosen_exhibits(std::span<const std::string> names);

}  // namespace rayshoot::gallery
