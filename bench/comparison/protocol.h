#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Plans that have a name, so that a claim can say what was measured in one word.
namespace rayshoot {

struct Protocol {
    std::string name;
    std::vector<std::string> scenes;
    std::vector<std::string> structures;  ///< ours; others may be asked for instead
    std::vector<std::string> yardsticks;  ///< always in it
    std::string size;                     ///< WxH of the image rays are recorded from
    int least_repetitions = 0;            ///< blocks
};

/// speed: the fastest structure against every public path and build quality of Embree.
/// subdivision: grid, octree and BSP against the same, on scenes that suit them and such that do
/// not. Throws std::invalid_argument, saying which there are, for any other name.
Protocol protocol(std::string_view name);

}  // namespace rayshoot
