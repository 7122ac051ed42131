#pragma once

#include "data/scene.h"

namespace rayshoot {

/// Throws std::invalid_argument, with the remedy, for a light of `scene` that is not one:
/// intensities that are negative or infinite, directions that are not of unit length, shapes
/// without area, primitives that do not exist, are of the wrong kind, move differently or are not
/// where the light is, facing as it does; samples that do not enclose it.
void require_valid(const Light& light, const Scene& scene);

}  // namespace rayshoot
