#pragma once

#include "data/scene.h"

#include <string>
#include <string_view>
#include <vector>

/// Scene strings: how scenes are named everywhere.
///
///     spd/balls   spd/tetra:size=8   soup:count=100000,seed=7     a generated scene
///     mesh/bunny  mesh/spot:loop=2                                a mesh of the catalogue
///     gallery/glass                                               a scene of data/gallery
///     path/to/scene.nff.xz   model.ply:loop=1,precision=watertight   a file
///
///     car.aff:frame=120          swing.nff:frame=3,frames=24,shutter=0.5      a moment of it
///
/// Every scene has the option precision=default|watertight. A relative path that does not exist is
/// looked for below $RAYSHOOT_SCENES as well.
namespace rayshoot {

/// Throws std::invalid_argument, saying what exists or what to do, when there is no such scene or
/// its file is unsound. Not to be called from two threads at once (see read_mesh).
Scene load_scene(std::string_view scene);

/// The scene at frame `frame` of `frames`, 0 first: of an animation (.nff, .aff) by its options,
/// else the scene itself; of 1 frame: load_scene(scene), which may name a frame itself. Throws
/// std::invalid_argument as load_scene does, where `scene` has a frame already, and unless 0 <=
/// frame < frames.
Scene load_frame(std::string_view scene, int frame, int frames);

struct SceneInfo {
    std::string name;     ///< what load_scene takes
    std::string options;  ///< as help shows them: "size=1..9 (4)"; precision is not repeated
    std::string summary;
    bool available = true;
    std::string command;  ///< what gets it where it is not available, else empty
};

/// The generated scenes, the meshes of the catalogue, the gallery's scenes and the files below
/// $RAYSHOOT_SCENES.
std::vector<SceneInfo> list_scenes();

}  // namespace rayshoot
