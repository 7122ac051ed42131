#pragma once

#include "data/scene.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Meshes by name (`mesh/bunny`), wherever they come from.
namespace rayshoot {

/// Who brings the file, and with it the folder that it is looked for in.
enum class MeshSource {
    cgal,        ///< Debian's libcgal-demo: meshes/cgal of the data folder
    fetched,     ///< data/fetch.sh: meshes/fetched of the data folder
    collection,  ///< the user's own scenes: meshes below $RAYSHOOT_SCENES
};

/// From inside, where the framing camera and its lamp would see the walls' backs.
struct Interior {
    Camera camera;
    vec3 lamp;
};

struct MeshEntry {
    std::string_view name;  ///< of the scene: "mesh/dragon"
    std::string_view file;
    MeshSource source;
    std::string_view summary;  ///< one line: triangles, and what is special
    std::optional<Interior> interior = {};
};

std::span<const MeshEntry> mesh_catalogue();
const MeshEntry* find_mesh(std::string_view name);

/// Where the file is; nothing when it is not there. A fetched mesh may lie in the collection.
std::optional<std::filesystem::path> locate(const MeshEntry& mesh);
/// What to do to get it, as one line for the user.
std::string how_to_get(const MeshEntry& mesh);

/// $RAYSHOOT_DATA; else the data folder of the source tree; else the installed one.
std::filesystem::path data_folder();
/// $RAYSHOOT_SCENES, where it is set and a folder.
std::optional<std::filesystem::path> scene_collection();

}  // namespace rayshoot
