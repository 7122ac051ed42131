#pragma once

#include "data/scene.h"
#include "data/scene_options.h"

#include <filesystem>
#include <string>

/// Scenes in files of their own, by the ending of the name.
namespace rayshoot {

/// Whether files that end so are read: .nff, .aff, .obj, .ply, .off, .stl, also .xz or .gz.
bool known_format(const std::filesystem::path& path);

/// Whether files that end so have frames: .nff, .aff.
bool is_animation(const std::filesystem::path& path);

/// The option `precision`, which every scene has.
Precision precision_of(const SceneOptions& options);

/// `name`: the file's, as errors show it. Throws std::invalid_argument, saying what to do, for an
/// option that it does not have and a file that is unsound.
Scene load_file(const std::filesystem::path& path, const std::string& name,
                const SceneOptions& options);

}  // namespace rayshoot
