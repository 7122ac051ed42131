#include "data/scene_file.h"

#include "data/aff.h"
#include "data/animation.h"
#include "data/file.h"
#include "data/mesh.h"
#include "data/nff.h"
#include "data/obj.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace rayshoot {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> formats{".nff", ".aff", ".obj", ".ply", ".off", ".stl"};
constexpr int most_levels = 8;  // of subdivision; the triangle bound of subdivide() ends it sooner

/// Material libraries lie beside their OBJ file; one that is not there is left out.
MaterialLibrary libraries_beside(const fs::path& obj) {
    return [folder = obj.parent_path()](const std::string& name) -> std::optional<std::string> {
        std::error_code error;
        if (!fs::is_regular_file(folder / name, error)) return std::nullopt;
        return read_file(folder / name);
    };
}

Mesh load_mesh(const fs::path& path, const std::string& name) {
    const std::string text = read_file(path);
    const std::string format = format_of(path);
    return format == ".obj" ? read_obj(text, name, libraries_beside(path))
                            : read_mesh(text, format, name);
}

Frame frame_of(const SceneOptions& options) {
    options.require_known({"frame", "frames", "shutter"});
    Frame frame;
    if (options.contains("frames")) frame.of = options.integer("frames", 1, 1, most_frames);
    frame.number = options.integer("frame", 0, 0, (frame.of > 0 ? frame.of : most_frames) - 1);
    if (options.contains("shutter")) frame.shutter = options.number("shutter", 0, 0, 1);
    return frame;
}

/// The files that one in `folder` includes.
AffFiles includes_in(const fs::path& folder) {
    return [folder](const std::string& path) { return read_file(folder / path); };
}

/// `name`: the file's, as errors show it.
Scene load_animation(const fs::path& path, const std::string& name, Precision precision,
                     const Frame& frame) {
    const std::string text = read_file(path);
    if (format_of(path) == ".nff") return read_nff(text, name, precision, frame);
    const AffModel model = read_aff_model(text, name, includes_in(path.parent_path()));
    return aff_scene(model, name, precision, frame);
}

}  // namespace

bool known_format(const fs::path& path) {
    return std::ranges::find(formats, format_of(path)) != formats.end();
}

bool is_animation(const fs::path& path) {
    return format_of(path) == ".nff" || format_of(path) == ".aff";
}

Precision precision_of(const SceneOptions& options) {
    const std::string given = options.text("precision", "default");
    if (given == "watertight") return Precision::watertight;
    if (given != "default")
        throw std::invalid_argument("precision=" + given + " is not one of default, watertight");
    return Precision::standard;
}

Scene load_file(const fs::path& path, const std::string& name, const SceneOptions& options) {
    const Precision precision = precision_of(options);
    const SceneOptions rest = options.without("precision");
    if (is_animation(path)) return load_animation(path, name, precision, frame_of(rest));
    rest.require_known({"loop"});
    const int levels = rest.integer("loop", 0, 0, most_levels);
    return mesh_scene(subdivide(load_mesh(path, name), levels, name), precision, name);
}

}  // namespace rayshoot
