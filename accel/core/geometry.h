#pragma once

#include "accel/core/primitive/frustum.h"
#include "accel/core/primitive/motion.h"
#include "accel/core/primitive/polygon.h"
#include "accel/core/primitive/sphere.h"
#include "accel/core/primitive/triangle.h"

#include <optional>
#include <span>
#include <vector>

/// All primitives of a scene, with what a structure may ask of each. Immutable once built.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class PrimitiveKind : std::uint8_t { triangle, sphere, frustum, polygon };
inline constexpr int primitive_kinds = 4;

/// A property of the geometry, so every structure of a run shares it.
inline constexpr std::uint32_t no_motion = 0;

/// What a primitive's number stands for.
struct PrimitiveRef {
    PrimitiveKind kind;
    std::uint32_t index;               ///< among the primitives of its kind
    std::uint32_t motion = no_motion;  ///< 1 + index of its motion; no_motion: it stands still
};

/// The unit normals of a hit, as stored: outward for spheres and frusta, by winding (right-handed)
/// for triangles and polygons; never turned towards the ray.
struct Normals {
    vec3 geometric;
    vec3 shading;  ///< interpolated where the scene gives vertex normals, else the geometric one
};

class Geometry {
public:
    std::uint32_t size() const { return static_cast<std::uint32_t>(refs_.size()); }
    Precision precision() const { return precision_; }
    const PrimitiveRef& ref(std::uint32_t primitive) const { return refs_[primitive]; }
    std::array<std::uint32_t, primitive_kinds> count_by_kind() const;

    /// The primitive's own bounds, over the whole shutter: what its hits are clamped to.
    const Box& bounds(std::uint32_t primitive) const { return bounds_[primitive]; }
    const Box& bounds() const { return scene_bounds_; }
    /// The bounds of all primitives, in their order.
    std::span<const Box> all_bounds() const { return bounds_; }

    /// Bounds of the part of a primitive inside `box`, grown by `radius` (see error_radius) and
    /// never larger than its own bounds; empty when no part is inside. Movers: their whole bounds.
    Box clipped_bounds(std::uint32_t primitive, const Box& box, float radius) const;
    /// False only when no point of the primitive, grown by `radius`, is in the closed box.
    bool overlaps(std::uint32_t primitive, const Box& box, float radius) const;
    /// max over the primitive's points x of dot(x, direction), rounded up; over the whole shutter.
    float support(std::uint32_t primitive, const vec3& direction) const;

    /// How far from its primitive a reported point origin + t * direction can lie, for rays that
    /// start within `reach` of the scene bounds' centre (accel/core/README.md derives it).
    float error_radius(float reach) const;

    Normals normal(const Ray& ray, const Hit& hit) const;

    /// The primitive's data, at rest.
    Triangle triangle(std::uint32_t index) const {
        const auto& [a, b, c] = triangles_[index];
        return {vertices_[a], vertices_[b], vertices_[c]};
    }
    const Sphere& sphere(std::uint32_t index) const { return spheres_[index]; }
    const Frustum& frustum(std::uint32_t index) const { return frusta_[index]; }
    const Polygon& polygon(std::uint32_t index) const { return polygons_[index]; }
    const Motion& motion(std::uint32_t motion) const { return motions_[motion - 1]; }

    /// The indexed mesh behind the triangles (yardsticks share these buffers).
    std::span<const vec3> vertices() const { return vertices_; }
    /// Empty, or one per vertex; zero: none there.
    std::span<const vec3> vertex_normals() const { return vertex_normals_; }
    std::span<const std::array<std::uint32_t, 3>> triangles() const { return triangles_; }
    bool only_static_triangles() const;
    bool has_motion() const { return !motions_.empty(); }

    /// Distance by which bounds are padded beyond the primitive, besides the own rounding.
    float padding() const { return padding_; }
    std::size_t bytes() const;

private:
    friend class GeometryBuilder;
    Box rest_bounds(const PrimitiveRef& ref) const;

    std::vector<PrimitiveRef> refs_;
    std::vector<Box> bounds_;
    Box scene_bounds_;
    Precision precision_ = Precision::standard;
    float padding_ = 0;
    std::vector<vec3> vertices_;
    std::vector<vec3> vertex_normals_;  ///< empty, or one per vertex; zero: none there
    std::vector<std::array<std::uint32_t, 3>> triangles_;
    std::vector<Sphere> spheres_;
    std::vector<Frustum> frusta_;
    std::vector<Polygon> polygons_;
    std::vector<Motion> motions_;
};

/// Collects primitives; a primitive's number is the order in which it was added.
/// Every add_* throws std::invalid_argument for numbers that are not finite, indices that do not
/// exist, a negative radius, or more than 2^32 - 2 primitives.
class GeometryBuilder {
public:
    std::uint32_t add_vertex(const vec3& position);
    std::uint32_t add_vertex(const vec3& position, const vec3& normal);
    std::uint32_t add_triangle(std::array<std::uint32_t, 3> vertices,
                               std::uint32_t motion = no_motion);
    /// The same with three new vertices.
    std::uint32_t add_triangle(const vec3& a, const vec3& b, const vec3& c,
                               std::uint32_t motion = no_motion);
    std::uint32_t add_sphere(const Sphere& sphere, std::uint32_t motion = no_motion);
    std::uint32_t add_frustum(const Frustum& frustum, std::uint32_t motion = no_motion);
    /// Three corners become a triangle; `normals`: empty or one per corner.
    std::uint32_t add_polygon(std::span<const vec3> corners, std::span<const vec3> normals = {},
                              std::uint32_t motion = no_motion);
    /// Returns the number by which add_* take it.
    std::uint32_t add_motion(const Motion& motion);

    std::uint32_t size() const { return geometry_.size(); }
    Geometry build(Precision precision = Precision::standard) &&;

private:
    std::uint32_t add(PrimitiveKind kind, std::size_t index, std::uint32_t motion);
    Geometry geometry_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
