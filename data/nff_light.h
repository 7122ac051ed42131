#pragma once

#include "data/scene.h"
#include "data/tokens.h"

/// NFF's extension for lights in physical units: `light kind ...`.
namespace rayshoot {

struct NffLight {
    Light light;
    bool visible = false;  ///< it is geometry as well, which rays hit
};

/// What follows the word `light`. data/README.md has the kinds. Refuses what makes no light, with
/// the line.
NffLight read_light(Tokens& tokens);

}  // namespace rayshoot
