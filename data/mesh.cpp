#include "data/mesh.h"

#include "data/mesh_essence.h"
#include "data/mesh_importer.h"

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <sstream>
#include <stdexcept>

namespace rayshoot {

namespace {

MeshEssence essence_of(std::string_view text, std::string_view format, const std::string& name) {
    if (format == ".ply") return ply_essence(text, name);
    if (format == ".off") return off_essence(text, name);
    if (format == ".stl") return stl_essence(text, name);
    throw std::invalid_argument(name + ": '" + std::string(format) +
                                "' is no mesh format; there are .ply, .off, .stl and .obj");
}

void require_equal(std::uint64_t delivered, std::uint64_t declared, const std::string& what,
                   const std::string& name) {
    if (delivered != declared)
        throw std::invalid_argument(name + ": the file has " + std::to_string(declared) + " " +
                                    what + ", but OpenMesh delivers " + std::to_string(delivered) +
                                    "; convert the file to another format");
}

void read_by_openmesh(MeshEssence& essence, std::string_view format, const std::string& name,
                      MeshImporter& importer) {
    std::istringstream in(std::move(essence.text));
    OpenMesh::IO::Options options;
    if (essence.binary) options += OpenMesh::IO::Options::Binary;
    if (essence.normals) options += OpenMesh::IO::Options::VertexNormal;
    const bool success =
        OpenMesh::IO::IOManager().read(in, std::string(format.substr(1)), importer, options);
    const bool reads_to_the_end = format == ".stl" && !essence.binary;
    if (!success || (in.fail() && !reads_to_the_end))
        throw std::invalid_argument(name + ": OpenMesh cannot read it beyond vertex " +
                                    std::to_string(importer.n_vertices()) + " and face " +
                                    std::to_string(importer.n_faces()) + "; repair the file");
}

/// Puts the facets back that a reader which merges equal points would have lost.
void restore(const std::vector<MeshEssence::Facet>& facets, Mesh& mesh) {
    if (facets.empty()) return;
    std::vector<std::array<std::uint32_t, 3>> all;
    auto kept = mesh.triangles.begin();
    for (const MeshEssence::Facet& facet : facets) {
        const auto before = static_cast<std::ptrdiff_t>(facet.place - all.size());
        all.insert(all.end(), kept, kept + before);
        kept += before;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), facet.corners.begin(), facet.corners.end());
        all.push_back({first, first + 1, first + 2});
    }
    all.insert(all.end(), kept, mesh.triangles.end());
    mesh.triangles = std::move(all);
}

}  // namespace

void Mesh::add_fan(std::span<const std::uint32_t> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

Mesh read_mesh(std::string_view text, std::string_view format, const std::string& name) {
    if (text.empty())
        throw std::invalid_argument(name + ": the file is empty; fetch or copy it again");
    MeshEssence essence = essence_of(text, format, name);
    omerr().disable();  // OpenMesh's own reports; what is wrong is thrown here
    MeshImporter importer(name);
    if (essence.faces + essence.collapsed.size() == 0)
        throw std::invalid_argument(name + ": the mesh has no faces; there is nothing to see");
    if (essence.faces > 0) read_by_openmesh(essence, format, name, importer);
    if (format != ".stl")  // which has no vertices of its own
        require_equal(importer.n_vertices(), essence.vertices, "vertices", name);
    require_equal(importer.faces(), essence.faces, "faces", name);
    require_equal(importer.corners(), essence.corners, "corners", name);
    Mesh mesh = std::move(importer).take();
    restore(essence.collapsed, mesh);
    return mesh;
}

}  // namespace rayshoot
