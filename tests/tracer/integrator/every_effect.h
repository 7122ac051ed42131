#pragma once

#include "data/scene.h"

namespace rayshoot::tracer_tests {

/// Moving things, a moving camera with a lens, lamps of every kind and surfaces of every model.
Scene every_effect();

}  // namespace rayshoot::tracer_tests
