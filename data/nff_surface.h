#pragma once

#include "data/scene.h"
#include "data/tokens.h"

/// NFF's extension for physical surfaces: `surface model [field value ...] ...`.
namespace rayshoot {

/// What follows the word `surface`, up to the first word that is no field. data/README.md has the
/// models and fields. Refuses what is out of a field's range, with the line.
Material read_surface(Tokens& tokens);

}  // namespace rayshoot
