#include "data/scenes.h"

#include "data/animation.h"
#include "data/gallery_scenes.h"
#include "data/generators/generators.h"
#include "data/mesh_catalogue.h"
#include "data/scene_file.h"
#include "data/scene_options.h"
#include "data/tokens.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace rayshoot {

namespace {

namespace fs = std::filesystem;

bool present(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

/// The gallery's by their names; others as given, or below the user's collection when only there.
fs::path resolved(const fs::path& path) {
    if (const GalleryScene* scene = find_gallery_scene(path.generic_string()))
        return file_of(*scene);
    if (path.is_absolute() || path.empty() || present(path)) return path;
    const auto collection = scene_collection();
    return collection && present(*collection / path) ? *collection / path : path;
}

Scene load_catalogued(const MeshEntry& mesh, const SceneOptions& options) {
    const auto path = locate(mesh);
    if (!path)
        throw std::invalid_argument(std::string(mesh.name) +
                                    " is not on this machine; to get it: " + how_to_get(mesh));
    Scene scene = load_file(*path, std::string(mesh.file), options);
    if (mesh.interior) {
        scene.camera = mesh.interior->camera;
        Light& lamp = scene.lights.front();
        lamp.position = mesh.interior->lamp;
        lamp.samples = {lamp.position, lamp.position};
    }
    return scene;
}

[[noreturn]] void refuse_unknown(std::string_view name) {
    std::string known;
    for (const GeneratorInfo& generator : generators()) known += std::string(generator.name) + ", ";
    for (const MeshEntry& mesh : mesh_catalogue()) known += std::string(mesh.name) + ", ";
    for (const GalleryScene& shown : gallery_scenes()) known += std::string(shown.name) + ", ";
    throw std::invalid_argument(quoted(name) + " is no scene; there are " + known +
                                "and files that end in .nff, .aff, .obj, .ply, .off or .stl "
                                "(also .xz or .gz)");
}

/// The scene's name and its options: the last colon of the last folder's part divides them.
std::pair<std::string_view, std::string_view> divided(std::string_view scene) {
    const std::size_t slash = scene.rfind('/');
    const std::size_t colon = scene.find(':', slash == scene.npos ? 0 : slash);
    if (colon == scene.npos || present(fs::path(scene))) return {scene, {}};
    return {scene.substr(0, colon), scene.substr(colon + 1)};
}

std::string options_of(const GeneratorInfo& generator) {
    std::ostringstream text;
    text << std::setprecision(std::numeric_limits<double>::digits10);
    for (const GeneratorOption& option : generator.options)
        text << (text.tellp() > 0 ? ", " : "") << option.name << "=" << option.lowest << ".."
             << option.highest << " (" << option.fallback << ")";
    return text.str();
}

constexpr const char* animation_options = "frame=0.., frames=1.., shutter=0..1";

void append_gallery(std::vector<SceneInfo>& scenes) {
    for (const GalleryScene& shown : gallery_scenes()) {
        const bool available = present(file_of(shown));
        scenes.push_back({std::string(shown.name), animation_options, std::string(shown.summary),
                          available, available ? "" : how_to_get(shown)});
    }
}

void append_collection(std::vector<SceneInfo>& scenes) {
    const auto folder = scene_collection();
    if (!folder) return;
    std::vector<std::string> names;
    std::error_code error;
    for (fs::recursive_directory_iterator file(*folder, error), end; !error && file != end;
         file.increment(error))
        if (file->is_regular_file(error) && known_format(file->path()))
            names.push_back(file->path().lexically_relative(*folder).generic_string());
    std::ranges::sort(names);
    for (const std::string& name : names)
        scenes.push_back({name, is_animation(name) ? animation_options : "loop=0..8 (0)",
                          "a file below $RAYSHOOT_SCENES", true, ""});
}

}  // namespace

Scene load_scene(std::string_view scene) {
    const auto [name, option_text] = divided(scene);
    if (name.empty())
        throw std::invalid_argument("the scene string is empty; name a scene or give a file");
    const SceneOptions options(name, option_text);
    Scene result;
    if (is_generator(name)) {
        const Precision precision = precision_of(options);
        result = generate(name, options.without("precision"), precision);
    } else if (const MeshEntry* mesh = find_mesh(name)) {
        result = load_catalogued(*mesh, options);
    } else {
        const fs::path path = resolved(name);
        if (const GalleryScene* shown = find_gallery_scene(name); shown && !present(path))
            throw std::invalid_argument(
                std::string(name) + " is not on this machine; to get it: " + how_to_get(*shown));
        if (!path.empty() && !present(path) && !known_format(path)) refuse_unknown(name);
        if (present(path) && fs::is_regular_file(path) && !known_format(path))
            throw std::invalid_argument(
                std::string(name) +
                ": its name does not end in .nff, .aff, .obj, .ply, .off or "
                ".stl (also .xz or .gz); rename or convert it");
        result = load_file(path, std::string(name), options);
    }
    result.name = scene;
    return result;
}

Scene load_frame(std::string_view scene, int frame, int frames) {
    if (!(0 <= frame && frame < frames && frames <= most_frames))
        throw std::invalid_argument(
            "frame " + std::to_string(frame) + " of " + std::to_string(frames) +
            ": frames are numbered from 0, up to " + std::to_string(most_frames) + " of them");
    const auto [name, options] = divided(scene);
    if (frames == 1 || is_generator(name) || find_mesh(name) || !is_animation(resolved(name)))
        return load_scene(scene);
    const std::string moment =
        "frame=" + std::to_string(frame) + ",frames=" + std::to_string(frames);
    return load_scene(std::string(name) + ":" + moment + (options.empty() ? "" : ",") +
                      std::string(options));
}

std::vector<SceneInfo> list_scenes() {
    std::vector<SceneInfo> scenes;
    for (const GeneratorInfo& generator : generators())
        scenes.push_back({std::string(generator.name), options_of(generator),
                          std::string(generator.summary), true, ""});
    for (const MeshEntry& mesh : mesh_catalogue()) {
        const bool available = locate(mesh).has_value();
        scenes.push_back({std::string(mesh.name), "loop=0..8 (0)", std::string(mesh.summary),
                          available, available ? "" : how_to_get(mesh)});
    }
    append_gallery(scenes);
    append_collection(scenes);
    return scenes;
}

}  // namespace rayshoot
