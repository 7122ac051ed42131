#include "data/mesh.h"

#include <stdexcept>

/// How a mesh alone is looked at. In double, with + - * / sqrt only: the same on every machine.
namespace rayshoot {

namespace {

struct Extent {
    dvec3 centre;
    double diagonal;
};

Extent extent(const Mesh& mesh) {
    Box box;
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) box.include(mesh.vertices[corner]);
    if (box.empty()) return {dvec3(0), 1};
    const dvec3 lo(box.lo), hi(box.hi);
    const double diagonal = length(hi - lo);
    return {0.5 * (lo + hi), diagonal > 0 ? diagonal : 1};
}

vec3 place(const Extent& extent, const dvec3& direction, double diagonals) {
    const vec3 place(extent.centre + diagonals * extent.diagonal * normalised(direction));
    if (!finite(place))
        throw std::invalid_argument(
            "the mesh is too large to be looked at from outside in single "
            "precision; scale it down");
    return place;
}

Camera framing(const Extent& extent) {
    constexpr double distance = 1.2;  // diagonals; at 45 degrees all but a long diagonal fits
    Camera camera;
    camera.from = place(extent, dvec3(0.5, 0.35, 1), distance);
    camera.at = vec3(extent.centre);
    camera.up = vec3(0, 1, 0);
    camera.angle = 45;
    return camera;
}

Light lamp(const Extent& extent) {
    Light light;
    light.position = place(extent, dvec3(-0.4, 1, 0.8), 1.5);
    light.samples.include(light.position);
    return light;
}

GeometryBuilder geometry(const Mesh& mesh) {
    GeometryBuilder builder;
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        if (mesh.normals.empty()) {
            builder.add_vertex(mesh.vertices[i]);
            continue;
        }
        const dvec3 normal(mesh.normals[i]);
        const double size = length(normal);
        const bool usable = size > 0 && std::isfinite(size);
        builder.add_vertex(mesh.vertices[i], usable ? vec3(normal / size) : vec3(0));
    }
    for (const auto& triangle : mesh.triangles) builder.add_triangle(triangle);
    return builder;
}

}  // namespace

Scene mesh_scene(const Mesh& mesh, Precision precision, const std::string& name) try {
    Scene scene;
    const Extent whole = extent(mesh);
    scene.camera = framing(whole);
    scene.lights.push_back(lamp(whole));
    scene.background = vec3(0.25f, 0.3f, 0.4f);
    scene.materials = mesh.materials.empty() ? std::vector<Material>(1) : mesh.materials;
    scene.material_of = mesh.material_of.empty()
                            ? std::vector<std::uint32_t>(mesh.triangles.size(), 0)
                            : mesh.material_of;
    scene.geometry = geometry(mesh).build(precision);
    return scene;
} catch (const std::invalid_argument& error) {
    throw std::invalid_argument(name + ": " + error.what());
}

}  // namespace rayshoot
