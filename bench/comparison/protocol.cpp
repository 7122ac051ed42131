#include "bench/comparison/protocol.h"

#include <stdexcept>

namespace rayshoot {
namespace {

const std::vector<std::string> paths_of_embree{"embree",
                                               "embree:kernel=single",
                                               "embree:kernel=packet",
                                               "embree:kernel=stream",
                                               "embree:quality=high",
                                               "embree:kernel=single,quality=high",
                                               "embree:quality=low"};

/// Coherent and not, in the caches and beyond them, seen from outside and inside, and spheres.
Protocol speed() {
    return {.name = "speed",
            .scenes = {"mesh/bunny", "mesh/dragon", "mesh/sibenik", "soup:count=100000",
                       "mesh/horse:loop=3", "spd/balls"},
            .structures = {"bvh8"},
            .yardsticks = paths_of_embree,
            .size = "1024x1024",
            .least_repetitions = 15};
}

/// Even meshes, uneven ones, and small things in large places, with what cures these.
Protocol subdivision() {
    return {
        .name = "subdivision",
        .scenes = {"mesh/bunny", "mesh/dragon", "mesh/sibenik", "spd/balls", "spd/tree", "stadium"},
        .structures = {"grid", "grid:nested=recursive", "octree", "octree:overlap=bounds", "bsp"},
        .yardsticks = paths_of_embree,
        .size = "512x512",
        .least_repetitions = 15};
}

}  // namespace

Protocol protocol(std::string_view name) {
    if (name == "speed") return speed();
    if (name == "subdivision") return subdivision();
    throw std::invalid_argument("there is no protocol \"" + std::string(name) +
                                "\"; there are: speed, subdivision");
}

}  // namespace rayshoot
