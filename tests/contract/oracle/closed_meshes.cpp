#include "tests/contract/oracle/closed_meshes.h"

#include "tests/contract/scenes/shapes.h"

#include <map>
#include <utility>

namespace rayshoot::contract {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Vertices by position, so that neighbours share them.
class Mesh {
public:
    std::uint32_t vertex(const vec3& p) {
        const auto [place, fresh] =
            numbers_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(positions_.size()));
        if (fresh) positions_.push_back(p);
        return place->second;
    }
    const vec3& position(std::uint32_t vertex) const { return positions_[vertex]; }
    void add(const Corners& corners) { triangles_.push_back(corners); }

    Geometry build(Precision precision) const {
        GeometryBuilder builder;
        for (const vec3& p : positions_) builder.add_vertex(p);
        for (const Corners& corners : triangles_) builder.add_triangle(corners);
        return std::move(builder).build(precision);
    }

    std::vector<Corners> triangles_;

private:
    std::map<std::array<float, 3>, std::uint32_t> numbers_;
    std::vector<vec3> positions_;
};

/// The octahedron, each triangle cut in four `levels` times, vertices pushed onto the sphere.
Mesh sphere(int levels) {
    Mesh mesh;
    for (const float x : {1.0f, -1.0f})
        for (const float y : {1.0f, -1.0f})
            for (const float z : {1.0f, -1.0f})
                mesh.add({mesh.vertex(vec3(x, 0, 0)), mesh.vertex(vec3(0, y, 0)),
                          mesh.vertex(vec3(0, 0, z))});
    for (int level = 0; level < levels; ++level) {
        const std::vector<Corners> coarse = std::exchange(mesh.triangles_, {});
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            return mesh.vertex(normalised(mesh.position(a) + mesh.position(b)));
        };
        for (const auto& [a, b, c] : coarse) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const Corners& fine :
                 {Corners{a, ab, ca}, Corners{ab, b, bc}, Corners{ca, bc, c}, Corners{ab, bc, ca}})
                mesh.add(fine);
        }
    }
    return mesh;
}

Mesh divided_cube(int cells) {
    Mesh mesh;
    const auto at = [&](int axis, int side, int u, int v) {
        vec3 p;
        p[axis] = static_cast<float>(2 * side - 1);
        p[(axis + 1) % 3] = static_cast<float>(2 * u - cells) / static_cast<float>(cells);
        p[(axis + 2) % 3] = static_cast<float>(2 * v - cells) / static_cast<float>(cells);
        return mesh.vertex(p + vec3(0.1f, 0.2f, 0.3f));
    };
    for (int face = 0; face < 6; ++face)
        for (int u = 0; u < cells; ++u)
            for (int v = 0; v < cells; ++v) {
                const int axis = face / 2, side = face % 2;
                const std::uint32_t a = at(axis, side, u, v), b = at(axis, side, u + 1, v);
                const std::uint32_t c = at(axis, side, u + 1, v + 1), d = at(axis, side, u, v + 1);
                mesh.add({a, b, c});
                mesh.add({a, c, d});
            }
    return mesh;
}

Mesh torus(int around, int across) {
    Mesh mesh;
    const auto at = [&](int i, int k) {
        const auto [x, y] = circle(4 * static_cast<float>(i % around) / static_cast<float>(around));
        const auto [r, z] = circle(4 * static_cast<float>(k % across) / static_cast<float>(across));
        const float radius = 1 + 0.35f * r;
        return mesh.vertex(vec3(radius * x, radius * y, 0.35f * z));
    };
    for (int i = 0; i < around; ++i)
        for (int k = 0; k < across; ++k) {
            const std::uint32_t a = at(i, k), b = at(i + 1, k), c = at(i + 1, k + 1);
            mesh.add({a, b, c});
            mesh.add({a, c, at(i, k + 1)});
        }
    return mesh;
}

}  // namespace

std::vector<ClosedMesh> closed_meshes(Precision precision) {
    std::vector<ClosedMesh> meshes;
    meshes.push_back({"sphere", sphere(3).build(precision), vec3(0.01f, -0.02f, 0.03f)});
    meshes.push_back({"divided_cube", divided_cube(8).build(precision), vec3(0.15f, 0.2f, 0.25f)});
    meshes.push_back({"torus", torus(24, 14).build(precision), vec3(1, 0.01f, 0.02f)});
    return meshes;
}

}  // namespace rayshoot::contract
