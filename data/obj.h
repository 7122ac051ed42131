#pragma once

#include "data/mesh.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>

/// Wavefront OBJ by tinyobjloader: positions, vertex normals, faces with any number of corners,
/// relative indices, materials. Groups and objects are read as one mesh; lines and points left out.
namespace rayshoot {

/// The text of a material library that an OBJ file names; nothing when there is none.
using MaterialLibrary = std::function<std::optional<std::string>(const std::string& name)>;

/// `name`: the file's, for errors. Throws std::invalid_argument with name:line and the remedy for a
/// number that is none, a face with fewer than three corners, an index that names nothing, and for
/// a file without faces. A material that is not found is the default one.
Mesh read_obj(std::string_view text, const std::string& name, const MaterialLibrary& library);

}  // namespace rayshoot
