#pragma once

#include "data/scene.h"

#include <cmath>
#include <string>
#include <string_view>

/// NFF, Eric Haines' Neutral File Format: the scenes of the Standard Procedural Databases.
/// data/README.md has the entities and what this reader makes of them.
namespace rayshoot {

/// Reads the whole text; `name` is the file's, for errors. Throws std::invalid_argument with
/// name:line and the remedy for anything that is not NFF.
Scene read_nff(std::string_view text, const std::string& name,
               Precision precision = Precision::standard);

/// Each light's intensity where the file gives no colour: together they light a scene alike
/// however many there are.
inline float nff_light_intensity(std::size_t lights) {
    return 1.0f / std::sqrt(static_cast<float>(lights));
}

}  // namespace rayshoot
