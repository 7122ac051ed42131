#pragma once

#include "data/scene.h"

#include <string>
#include <string_view>
#include <vector>

/// The digests that every build must reproduce: tests/generators/digests.csv.
namespace rayshoot {

/// "spd/balls:size=3": a generator's name, and its options after a colon.
Scene generate_scene(std::string_view scene);

/// Each generator as it is by default and once otherwise.
std::vector<std::string> golden_scenes();

/// The file's line of a scene: "scene",primitives,digest.
std::string golden_line(const std::string& scene);

inline constexpr std::string_view golden_header = "scene,primitives,digest";

}  // namespace rayshoot
