#include "bench/comparison/standard.h"

#include "data/scenes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace rayshoot {
namespace {

constexpr std::array<std::string_view, 4> generated{"spd/balls", "spd/gears", "spd/tetra",
                                                    "spd/mount"};
/// Of those that setup.sh unpacks, so that every machine compares on the same ones.
constexpr std::array<std::string_view, 3> meshes{"mesh/bunny00", "mesh/elephant", "mesh/armadillo"};

}  // namespace

std::vector<std::string> standard_scenes() {
    std::vector<std::string> scenes(generated.begin(), generated.end());
    for (const SceneInfo& scene : list_scenes()) {
        const bool wanted = std::ranges::find(meshes, scene.name) != meshes.end();
        if (wanted && scene.available) scenes.push_back(scene.name);
    }
    return scenes;
}

std::vector<std::string> standard_structures(const Catalogue& catalogue) {
    std::vector<std::string> structures;
    for (const StructureEntry& entry : catalogue) {
        structures.push_back(std::string(entry.name) + (entry.complete ? "" : "+bvh"));
    }
    return structures;
}

}  // namespace rayshoot
