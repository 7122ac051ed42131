#pragma once

#include "data/animation.h"
#include "data/scene.h"

#include <cmath>
#include <string>
#include <string_view>

/// NFF, Eric Haines' Neutral File Format: the scenes of the Standard Procedural Databases, and our
/// extension of it: motion, lens, lights and surfaces in physical units. data/README.md has the
/// entities and what this reader makes of them.
namespace rayshoot {

/// Reads the whole text; `name` is the file's, for errors. Throws std::invalid_argument with
/// name:line and the remedy for anything that is not NFF. The animation lasts from 0 to 1; frame n
/// of N begins at n / N. A file without `move` and `turn` gives the same scene for every frame.
Scene read_nff(std::string_view text, const std::string& name,
               Precision precision = Precision::standard, const Frame& frame = {});

/// Each light's intensity where the file gives no colour: together they light a scene alike
/// however many there are.
inline float nff_light_intensity(std::size_t lights) {
    return 1.0f / std::sqrt(static_cast<float>(lights));
}

}  // namespace rayshoot
