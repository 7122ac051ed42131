#pragma once

#include "data/scene.h"

#include <string>
#include <string_view>

/// Triangle meshes as files give them: shared vertices, every face kept.
namespace rayshoot {

struct Mesh {
    std::vector<vec3> vertices;
    std::vector<vec3> normals;  ///< empty, or one per vertex; zero: none there
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<Material> materials;         ///< empty: one default material for all
    std::vector<std::uint32_t> material_of;  ///< empty, or one per triangle

    /// Adds a face with three or more corners as the fan round its first corner.
    void add_fan(std::span<const std::uint32_t> corners);
};

/// Reads PLY, OFF or STL (`format`: ".ply", ".off", ".stl") by OpenMesh; `name` is the file's, for
/// errors. Every vertex and face that the file declares is in the result, degenerate and
/// non-manifold ones included; else std::invalid_argument says what is wrong, where, and what to
/// do. Not to be called from two threads at once: OpenMesh's readers keep state.
Mesh read_mesh(std::string_view text, std::string_view format, const std::string& name);

/// Loop subdivision (Loop 1987), `levels` times, by OpenMesh; materials and normals are dropped.
/// Throws std::invalid_argument for a mesh that is not a manifold and for a result that is too
/// large.
Mesh subdivide(const Mesh& mesh, int levels, const std::string& name);

/// A scene of the mesh alone: a camera that frames it, one point light and its materials. `name` is
/// the file's, for errors.
Scene mesh_scene(const Mesh& mesh, Precision precision, const std::string& name);

}  // namespace rayshoot
