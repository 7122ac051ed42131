#pragma once

#include "accel/core/geometry.h"

#include <string>
#include <vector>

/// Closed meshes with shared vertices: nothing gets out of them.
namespace rayshoot::contract {

struct ClosedMesh {
    std::string name;
    Geometry geometry;
    vec3 inside;  ///< a point well inside, that sees its surface all round
};

/// A sphere of triangles, a finely divided cube and a torus.
std::vector<ClosedMesh> closed_meshes(Precision precision);

}  // namespace rayshoot::contract
