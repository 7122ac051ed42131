#include "data/mesh_importer.h"

#include <stdexcept>

namespace rayshoot {

MeshImporter::VertexHandle MeshImporter::add_vertex(const Vec3f& point) {
    const VertexHandle vertex = add_vertex();
    set_point(vertex, point);
    return vertex;
}

MeshImporter::VertexHandle MeshImporter::add_vertex() {
    mesh_.vertices.emplace_back(0.0f);
    return VertexHandle(static_cast<int>(mesh_.vertices.size() - 1));
}

void MeshImporter::set_point(VertexHandle vertex, const Vec3f& point) {
    const vec3 position(point[0], point[1], point[2]);
    if (!finite(position))
        refuse("vertex " + std::to_string(vertex.idx()) +
               " (counted from 0) has a coordinate that is not finite; repair the mesh");
    mesh_.vertices[checked(vertex)] = position;
}

void MeshImporter::set_normal(VertexHandle vertex, const Vec3f& normal) {
    mesh_.normals.resize(mesh_.vertices.size(), vec3(0));
    mesh_.normals[checked(vertex)] = vec3(normal[0], normal[1], normal[2]);
}

void MeshImporter::set_normal(VertexHandle vertex, const Vec3d& normal) {
    set_normal(vertex, Vec3f(normal));
}

MeshImporter::FaceHandle MeshImporter::add_face(const VHandles& corners) {
    if (corners.size() < 3)
        refuse("face " + std::to_string(faces_) + " (counted from 0) has only " +
               std::to_string(corners.size()) + " corners; remove it");
    std::vector<std::uint32_t> fan;
    for (const VertexHandle corner : corners) {
        if (corner.idx() < 0 || corner.idx() >= static_cast<int>(mesh_.vertices.size()))
            refuse("face " + std::to_string(faces_) + " (counted from 0) names vertex " +
                   std::to_string(corner.idx()) + ", but the vertices are 0 to " +
                   std::to_string(static_cast<int>(mesh_.vertices.size()) - 1) +
                   "; the file is damaged or its faces come first");
        fan.push_back(static_cast<std::uint32_t>(corner.idx()));
    }
    mesh_.add_fan(fan);
    corners_ += corners.size();
    return FaceHandle(static_cast<int>(faces_++));
}

std::size_t MeshImporter::checked(VertexHandle vertex) const {
    if (vertex.idx() < 0 || vertex.idx() >= static_cast<int>(mesh_.vertices.size()))
        throw std::logic_error("OpenMesh sets a vertex that it has not added");
    return static_cast<std::size_t>(vertex.idx());
}

void MeshImporter::refuse(const std::string& message) const {
    throw std::invalid_argument(name_ + ": " + message);
}

}  // namespace rayshoot
