#pragma once

#include "data/mesh.h"

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

#include <string>

/// What OpenMesh's readers deliver, taken as an indexed mesh. Nothing is dropped: a face that
/// cannot be taken is an error.
namespace rayshoot {

class MeshImporter final : public OpenMesh::IO::BaseImporter {
public:
    explicit MeshImporter(std::string name) : name_(std::move(name)) {}

    const Mesh& mesh() const { return mesh_; }
    Mesh take() && { return std::move(mesh_); }
    std::uint64_t faces() const { return faces_; }
    std::uint64_t corners() const { return corners_; }

    using Vec2f = OpenMesh::Vec2f;
    using Vec3f = OpenMesh::Vec3f;
    using Vec3d = OpenMesh::Vec3d;
    using Vec4f = OpenMesh::Vec4f;
    using Vec3uc = OpenMesh::Vec3uc;
    using Vec4uc = OpenMesh::Vec4uc;
    using VertexHandle = OpenMesh::VertexHandle;
    using HalfedgeHandle = OpenMesh::HalfedgeHandle;
    using EdgeHandle = OpenMesh::EdgeHandle;
    using FaceHandle = OpenMesh::FaceHandle;
    using StatusInfo = OpenMesh::Attributes::StatusInfo;

    VertexHandle add_vertex(const Vec3f& point) override;
    VertexHandle add_vertex() override;
    FaceHandle add_face(const VHandles& corners) override;
    void set_point(VertexHandle vertex, const Vec3f& point) override;
    void set_normal(VertexHandle vertex, const Vec3f& normal) override;
    void set_normal(VertexHandle vertex, const Vec3d& normal) override;

    std::size_t n_vertices() const override { return mesh_.vertices.size(); }
    std::size_t n_faces() const override { return faces_; }
    std::size_t n_edges() const override { return 0; }
    bool is_triangle_mesh() const override { return false; }

    // Halfedges, colours, textures and status are not wanted.
    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>&) override {}
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(VertexHandle, const Vec2f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
    void set_texcoord(VertexHandle, const Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
    void set_color(VertexHandle, const Vec3uc&) override {}
    void set_color(VertexHandle, const Vec4uc&) override {}
    void set_color(VertexHandle, const Vec3f&) override {}
    void set_color(VertexHandle, const Vec4f&) override {}
    void set_color(EdgeHandle, const Vec3uc&) override {}
    void set_color(EdgeHandle, const Vec4uc&) override {}
    void set_color(EdgeHandle, const Vec3f&) override {}
    void set_color(EdgeHandle, const Vec4f&) override {}
    void set_color(FaceHandle, const Vec3uc&) override {}
    void set_color(FaceHandle, const Vec4uc&) override {}
    void set_color(FaceHandle, const Vec3f&) override {}
    void set_color(FaceHandle, const Vec4f&) override {}
    void set_normal(FaceHandle, const Vec3f&) override {}
    void set_normal(FaceHandle, const Vec3d&) override {}
    void set_status(VertexHandle, const StatusInfo&) override {}
    void set_status(HalfedgeHandle, const StatusInfo&) override {}
    void set_status(EdgeHandle, const StatusInfo&) override {}
    void set_status(FaceHandle, const StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}

private:
    [[noreturn]] void refuse(const std::string& message) const;
    std::size_t checked(VertexHandle vertex) const;

    std::string name_;
    Mesh mesh_;
    std::uint64_t faces_ = 0, corners_ = 0;
};

}  // namespace rayshoot
