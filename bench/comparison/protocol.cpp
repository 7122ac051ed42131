#include "bench/comparison/protocol.h"

#include <stdexcept>

namespace rayshoot {
namespace {

/// Coherent and not, in the caches and beyond them, seen from outside and inside, and spheres.
Protocol speed() {
    return {.name = "speed",
            .scenes = {"mesh/bunny", "mesh/dragon", "mesh/sibenik", "soup:count=100000",
                       "mesh/horse:loop=3", "spd/balls"},
            .structures = {"bvh8"},
            .yardsticks = {"embree", "embree:kernel=single", "embree:kernel=packet",
                           "embree:kernel=stream", "embree:quality=high",
                           "embree:kernel=single,quality=high", "embree:quality=low"},
            .size = "1024x1024",
            .least_repetitions = 15};
}

}  // namespace

Protocol protocol(std::string_view name) {
    if (name == "speed") return speed();
    throw std::invalid_argument("there is no protocol \"" + std::string(name) +
                                "\"; there is: speed");
}

}  // namespace rayshoot
