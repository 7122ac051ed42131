#include <algorithm>
#include <stdexcept>
#include <string>

#include "accel/core/geometry.h"
#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

void require_finite(const vec3& p, const char* what) {
    if (!finite(p))
        throw std::invalid_argument(std::string(what) + " must be finite, but is (" +
                                    std::to_string(p.x) + ", " + std::to_string(p.y) + ", " +
                                    std::to_string(p.z) + ")");
}

void require_radius(float radius, const char* what) {
    if (!(radius >= 0) || !std::isfinite(radius))
        throw std::invalid_argument(std::string(what) +
                                    " must be finite and not negative, but is " +
                                    std::to_string(radius));
}

/// Share of scene diagonal plus largest coordinate by which watertight bounds are padded: 15 for
/// the slab form and 16 for the shear, in units of 2^-24, seen from four diagonals away (README).
constexpr double watertight_padding = 0x1p-19;

float scene_padding(const Box& scene) {
    const double diagonal = length(dvec3(scene.hi) - dvec3(scene.lo));
    return rounded_up(watertight_padding * (diagonal + double(largest_coordinate(scene))));
}

}  // namespace

std::uint32_t GeometryBuilder::add_vertex(const vec3& position) {
    require_finite(position, "a vertex");
    if (geometry_.vertices_.size() >= 0xffffffff)
        throw std::invalid_argument("more than 2^32 - 1 vertices");
    geometry_.vertices_.push_back(position);
    if (!geometry_.vertex_normals_.empty()) geometry_.vertex_normals_.emplace_back(0);
    return static_cast<std::uint32_t>(geometry_.vertices_.size() - 1);
}

std::uint32_t GeometryBuilder::add_vertex(const vec3& position, const vec3& normal) {
    require_finite(normal, "a vertex normal");
    const std::uint32_t vertex = add_vertex(position);
    geometry_.vertex_normals_.resize(geometry_.vertices_.size(), vec3(0));
    geometry_.vertex_normals_.back() = normal;
    return vertex;
}

std::uint32_t GeometryBuilder::add(PrimitiveKind kind, std::size_t index, std::uint32_t motion) {
    if (motion > geometry_.motions_.size())
        throw std::invalid_argument("there is no motion " + std::to_string(motion) + ", only " +
                                    std::to_string(geometry_.motions_.size()));
    if (geometry_.refs_.size() >= no_primitive - 1)
        throw std::invalid_argument("more than 2^32 - 2 primitives");
    geometry_.refs_.push_back({kind, static_cast<std::uint32_t>(index), motion});
    return static_cast<std::uint32_t>(geometry_.refs_.size() - 1);
}

std::uint32_t GeometryBuilder::add_triangle(std::array<std::uint32_t, 3> vertices,
                                            std::uint32_t motion) {
    for (const std::uint32_t vertex : vertices)
        if (vertex >= geometry_.vertices_.size())
            throw std::invalid_argument("a triangle uses vertex " + std::to_string(vertex) +
                                        ", but there are " +
                                        std::to_string(geometry_.vertices_.size()));
    const std::uint32_t number = add(PrimitiveKind::triangle, geometry_.triangles_.size(), motion);
    geometry_.triangles_.push_back(vertices);
    return number;
}

std::uint32_t GeometryBuilder::add_triangle(const vec3& a, const vec3& b, const vec3& c,
                                            std::uint32_t motion) {
    const std::uint32_t first = add_vertex(a), second = add_vertex(b), third = add_vertex(c);
    return add_triangle({first, second, third}, motion);
}

std::uint32_t GeometryBuilder::add_sphere(const Sphere& sphere, std::uint32_t motion) {
    require_finite(sphere.centre, "a sphere's centre");
    require_radius(sphere.radius, "a sphere's radius");
    const std::uint32_t number = add(PrimitiveKind::sphere, geometry_.spheres_.size(), motion);
    geometry_.spheres_.push_back(sphere);
    return number;
}

std::uint32_t GeometryBuilder::add_frustum(const Frustum& frustum, std::uint32_t motion) {
    require_finite(frustum.base, "a frustum's base");
    require_finite(frustum.apex, "a frustum's apex");
    require_radius(frustum.base_radius, "a frustum's base radius");
    require_radius(frustum.apex_radius, "a frustum's apex radius");
    const std::uint32_t number = add(PrimitiveKind::frustum, geometry_.frusta_.size(), motion);
    geometry_.frusta_.push_back(frustum);
    return number;
}

std::uint32_t GeometryBuilder::add_polygon(std::span<const vec3> corners,
                                           std::span<const vec3> normals, std::uint32_t motion) {
    for (const vec3& corner : corners) require_finite(corner, "a polygon's corner");
    for (const vec3& normal : normals) require_finite(normal, "a polygon's normal");
    Polygon polygon = make_polygon(corners, normals);
    if (corners.size() == 3) {
        std::array<std::uint32_t, 3> vertices{};
        for (std::size_t i = 0; i < 3; ++i)
            vertices[i] =
                normals.empty() ? add_vertex(corners[i]) : add_vertex(corners[i], normals[i]);
        return add_triangle(vertices, motion);
    }
    const std::uint32_t number = add(PrimitiveKind::polygon, geometry_.polygons_.size(), motion);
    geometry_.polygons_.push_back(std::move(polygon));
    return number;
}

std::uint32_t GeometryBuilder::add_motion(const Motion& motion) {
    require_rigid(motion);
    geometry_.motions_.push_back(motion);
    return static_cast<std::uint32_t>(geometry_.motions_.size());
}

Geometry GeometryBuilder::build(Precision precision) && {
    Geometry& g = geometry_;
    g.precision_ = precision;
    g.bounds_.clear();
    Box scene;
    for (const PrimitiveRef& ref : g.refs_) {
        const Box rest = g.rest_bounds(ref);
        g.bounds_.push_back(ref.motion == no_motion ? rest : swept(g.motion(ref.motion), rest));
        scene.include(g.bounds_.back());
    }
    if (precision == Precision::watertight && !g.refs_.empty()) g.padding_ = scene_padding(scene);
    for (Box& box : g.bounds_) {
        box = padded(box, g.padding_);
        g.scene_bounds_.include(box);
    }
    return std::move(geometry_);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
