#pragma once

#include "data/scene.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// What OpenMesh is given to read: the vertices and faces of a mesh file and nothing else, after
/// the file's layout has been checked from end to end. Its readers believe declared counts, misread
/// lists that they do not know and report success on broken input.
namespace rayshoot {

struct MeshEssence {
    std::string text;  ///< the file again, in the same format, without what is not needed
    bool binary = false;
    bool normals = false;  ///< one per vertex
    std::uint64_t vertices =
        0;                      ///< declared by the file and found in it; 0 for STL, which has none
    std::uint64_t faces = 0;    ///< likewise
    std::uint64_t corners = 0;  ///< of all faces together

    /// A facet that a reader which merges equal points would lose, and its place among all facets.
    struct Facet {
        std::uint64_t place;
        std::array<vec3, 3> corners;
    };
    std::vector<Facet> collapsed;  ///< not in `text`; by ascending place
};

/// Each throws std::invalid_argument with `name`, the line or element, and the remedy.
MeshEssence ply_essence(std::string_view text, const std::string& name);
MeshEssence off_essence(std::string_view text, const std::string& name);
MeshEssence stl_essence(std::string_view text, const std::string& name);

/// Throws when a file of so many bytes cannot hold `count` elements of at least `smallest` bytes.
void require_room(std::uint64_t count, std::uint64_t smallest, std::uint64_t bytes,
                  const std::string& elements, const std::string& name);

}  // namespace rayshoot
