#pragma once

#include "accel/core/catalogue.h"

#include <string>
#include <vector>

/// What the default comparison measures.
namespace rayshoot {

/// SPD scenes, and of the real meshes those that are on this machine.
std::vector<std::string> standard_scenes();

/// Every complete structure by itself, every partial one before the bvh.
std::vector<std::string> standard_structures(const Catalogue& catalogue);

}  // namespace rayshoot
