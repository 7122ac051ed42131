#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "data/scene.h"
#include "tracer/render.h"

/// Everything that can be said of an image in words: `key=value` pairs, on a command line or in a
/// file.
namespace rayshoot {

/// What settings say; the lens is put on the scene's camera.
struct ImageSettings {
    RenderSettings render;
    std::optional<float> f_stop, focal_length, focus_distance;  ///< Lens; scene units
    std::optional<int> blades;                                  ///< Lens
    std::optional<float> shutter_open, shutter_close;           ///< Camera; ray times
};

/// `text`: pairs divided by commas, as in "filter=hann,radius=1.7,spp=16,lens=f2.8", or "@FILE",
/// whose lines hold such pairs, blanks round them and what follows a '#' ignored. A later pair
/// replaces an earlier one of other settings, but no key may be given twice in one text. Throws
/// std::invalid_argument, with the file and line, for an unknown key, listing all of them, and for
/// a value out of range, saying what is accepted.
void apply_settings(std::string_view text, ImageSettings& settings);

/// Puts lens and shutter on the camera. A lens without a focal length or focus of its own is
/// lens_for's. Throws std::invalid_argument for a lens that is none.
void apply_to(Camera& camera, const ImageSettings& settings);

/// All keys, a line each: the key, what is accepted, the default, and what it means.
std::string describe_settings();

}  // namespace rayshoot
