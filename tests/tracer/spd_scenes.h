#pragma once

#include <array>

#include "tests/tracer/test_scenes.h"

namespace rayshoot::tracer_tests {

inline constexpr std::array spd_names{"balls", "gears",   "mount",  "rings", "teapot",  "tetra",
                                      "tree",  "lattice", "shells", "jacks", "sombrero"};

/// At the size of the published tables, where there are some.
Scene spd_scene(const std::string& name);

}  // namespace rayshoot::tracer_tests
