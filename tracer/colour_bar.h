#pragma once

#include "tracer/colour_map.h"

namespace rayshoot {

/// The legend of a scale: the map from low (left) to high (right), `width` pixels wide, 64 at
/// least, with ticks and their values below it, on white.
Image colour_bar(const ColourScale& scale, int width);

}  // namespace rayshoot
