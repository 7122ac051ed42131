#include "tests/generators/golden.h"

#include "data/generators/generators.h"

#include <algorithm>

namespace rayshoot {

Scene generate_scene(std::string_view scene) {
    const std::size_t colon = std::min(scene.find(':'), scene.size());
    const std::string_view name = scene.substr(0, colon);
    return generate(name, {name, scene.substr(std::min(colon + 1, scene.size()))});
}

std::vector<std::string> golden_scenes() {
    std::vector<std::string> scenes;
    for (const GeneratorInfo& info : generators()) scenes.emplace_back(info.name);
    for (const char* other :
         {"spd/balls:size=2", "spd/gears:size=2", "spd/mount:size=4", "spd/mount:size=8",
          "spd/rings:size=2", "spd/teapot:size=6", "spd/tetra:size=3", "spd/tree:size=5",
          "spd/lattice:size=3", "spd/shells:size=1", "spd/jacks:size=3", "spd/sombrero:size=2",
          "soup:count=1000,length=0.1,seed=7", "needles:count=1000,aspect=1e5,seed=7",
          "stadium:size=2"})
        scenes.emplace_back(other);
    return scenes;
}

std::string golden_line(const std::string& scene) {
    const Scene made = generate_scene(scene);
    return '"' + scene + "\"," + std::to_string(made.geometry.size()) + ',' + digest(made);
}

}  // namespace rayshoot
