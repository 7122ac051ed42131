#include "data/mesh.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>

#include <stdexcept>

namespace rayshoot {

namespace {

using Halfedges = OpenMesh::TriMesh_ArrayKernelT<>;

// Each level quadruples; a halfedge mesh takes about 250 bytes a triangle, so this is 2 GB.
constexpr std::uint64_t most_triangles = 8'000'000;

void require_bounded(std::uint64_t triangles, int levels, const std::string& name) {
    for (int level = 0; level < levels; ++level) {
        triangles *= 4;
        if (triangles > most_triangles)
            throw std::invalid_argument(name + ": loop=" + std::to_string(levels) +
                                        " makes more than " + std::to_string(most_triangles) +
                                        " triangles; at most loop=" + std::to_string(level) +
                                        " fits");
    }
}

[[noreturn]] void refuse(const std::string& name, std::size_t triangle, const std::string& reason) {
    throw std::invalid_argument(name + ": loop= wants a manifold, but triangle " +
                                std::to_string(triangle) + " (counted from 0) " + reason +
                                "; leave loop= out or repair the mesh");
}

/// Only the vertices that triangles use: the others would be smoothed for nothing.
Halfedges halfedges_of(const Mesh& mesh, const std::string& name) {
    Halfedges halfedges;
    std::vector<OpenMesh::VertexHandle> handles(mesh.vertices.size());
    const auto handle = [&](std::uint32_t vertex) {
        const vec3& p = mesh.vertices[vertex];
        if (!handles[vertex].is_valid())
            handles[vertex] = halfedges.add_vertex(Halfedges::Point(p.x, p.y, p.z));
        return handles[vertex];
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        if (a == b || b == c || c == a) refuse(name, i, "has only two different corners");
        const auto face = halfedges.add_face(handle(a), handle(b), handle(c));
        if (!face.is_valid())
            refuse(name, i,
                   "shares an edge with two others, is turned over against its "
                   "neighbour or meets others in a vertex only");
    }
    return halfedges;
}

}  // namespace

Mesh subdivide(const Mesh& mesh, int levels, const std::string& name) {
    if (levels == 0) return mesh;
    require_bounded(mesh.triangles.size(), levels, name);
    omerr().disable();  // OpenMesh's own reports; what is wrong is thrown here
    Halfedges halfedges = halfedges_of(mesh, name);
    OpenMesh::Subdivider::Uniform::LoopT<Halfedges> loop;
    loop.attach(halfedges);
    loop(static_cast<std::size_t>(levels));
    loop.detach();

    Mesh result;
    for (const auto vertex : halfedges.vertices()) {
        const auto& p = halfedges.point(vertex);
        result.vertices.emplace_back(p[0], p[1], p[2]);
    }
    for (const auto face : halfedges.faces()) {
        std::array<std::uint32_t, 3> corners{};
        auto corner = corners.begin();
        for (const auto vertex : halfedges.fv_range(face))
            *corner++ = static_cast<std::uint32_t>(vertex.idx());
        result.triangles.push_back(corners);
    }
    return result;
}

}  // namespace rayshoot
