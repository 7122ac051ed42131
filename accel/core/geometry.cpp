#include "accel/core/geometry.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "accel/core/primitive/extent.h"
#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/rounding.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Calls `ask` with the primitive's data at rest.
template <class Ask>
auto with_shape(const Geometry& geometry, const PrimitiveRef& ref, Ask&& ask) {
    switch (ref.kind) {
        case PrimitiveKind::triangle:
            return ask(geometry.triangle(ref.index));
        case PrimitiveKind::sphere:
            return ask(geometry.sphere(ref.index));
        case PrimitiveKind::frustum:
            return ask(geometry.frustum(ref.index));
        case PrimitiveKind::polygon:
            break;
    }
    return ask(geometry.polygon(ref.index));
}

/// max of dot(x, direction) over a box, rounded up.
float box_support(const Box& box, const vec3& direction) {
    double sum = 0, size = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double d = direction[axis];
        if (d == 0) continue;  // an unbounded box times zero
        const double term = d * double(d > 0 ? box.hi[axis] : box.lo[axis]);
        sum += term;
        size += std::abs(term);
    }
    return rounded_up(std::fma(0x1p-50, size, sum));
}

/// The smooth normal of a triangle whose vertices all have one.
vec3 interpolated(const std::array<vec3, 3>& normals, const Hit& hit, vec3 flat) {
    dvec3 sum(0);
    const std::array<double, 3> weights{1.0 - double(hit.u) - double(hit.v), hit.u, hit.v};
    for (std::size_t i = 0; i < 3; ++i) {
        if (normals[i] == vec3(0)) return flat;
        sum += weights[i] * dvec3(normals[i]);
    }
    const double size = length(sum);
    return size > 0 ? vec3(sum / size) : flat;
}

Normals flat(const vec3& normal) { return {normal, normal}; }

Normals triangle_normals(const Geometry& geometry, std::uint32_t index, const Hit& hit) {
    const vec3 geometric = geometric_normal(geometry.triangle(index));
    const std::span<const vec3> normals = geometry.vertex_normals();
    if (normals.empty()) return flat(geometric);
    const auto& [a, b, c] = geometry.triangles()[index];
    return {geometric, interpolated({normals[a], normals[b], normals[c]}, hit, geometric)};
}

Normals normals_at_rest(const Geometry& geometry, const PrimitiveRef& ref, const Ray& ray,
                        const Hit& hit) {
    const vec3 point = along(ray.origin, hit.t, ray.direction);
    switch (ref.kind) {
        case PrimitiveKind::triangle:
            return triangle_normals(geometry, ref.index, hit);
        case PrimitiveKind::sphere:
            return flat(normal_at(geometry.sphere(ref.index), point));
        case PrimitiveKind::frustum:
            return flat(normal_at(geometry.frustum(ref.index), point));
        case PrimitiveKind::polygon:
            break;
    }
    const Polygon& polygon = geometry.polygon(ref.index);
    return {geometric_normal(polygon), shading_normal(polygon, point)};
}

}  // namespace

std::array<std::uint32_t, primitive_kinds> Geometry::count_by_kind() const {
    std::array<std::uint32_t, primitive_kinds> counts{};
    for (const PrimitiveRef& ref : refs_) ++counts[static_cast<std::size_t>(ref.kind)];
    return counts;
}

bool Geometry::only_static_triangles() const {
    return std::all_of(refs_.begin(), refs_.end(), [](const PrimitiveRef& ref) {
        return ref.kind == PrimitiveKind::triangle && ref.motion == no_motion;
    });
}

Box Geometry::rest_bounds(const PrimitiveRef& ref) const {
    return with_shape(*this, ref, [](const auto& shape) { return rayshoot::bounds(shape); });
}

Box Geometry::clipped_bounds(std::uint32_t primitive, const Box& box, float radius) const {
    const PrimitiveRef& ref = refs_[primitive];
    const Box& own = bounds_[primitive];
    if (ref.motion != no_motion) return own.overlaps(box) ? own : Box{};
    const Box part = with_shape(
        *this, ref, [&](const auto& shape) { return rayshoot::clipped_bounds(shape, box); });
    return part.empty() ? Box{} : part.grown(radius).intersection(own);
}

bool Geometry::overlaps(std::uint32_t primitive, const Box& box, float radius) const {
    const PrimitiveRef& ref = refs_[primitive];
    if (ref.motion != no_motion)
        return !box.empty() && bounds_[primitive].grown(radius).overlaps(box);
    return with_shape(*this, ref,
                      [&](const auto& shape) { return rayshoot::overlaps(shape, box, radius); });
}

float Geometry::support(std::uint32_t primitive, const vec3& direction) const {
    const PrimitiveRef& ref = refs_[primitive];
    if (ref.motion != no_motion) return box_support(bounds_[primitive], direction);
    return with_shape(*this, ref,
                      [&](const auto& shape) { return rayshoot::support(shape, direction); });
}

Normals Geometry::normal(const Ray& ray, const Hit& hit) const {
    const PrimitiveRef& ref = refs_[hit.primitive];
    if (ref.motion == no_motion) return normals_at_rest(*this, ref, ray, hit);
    const Motion& moves = motion(ref.motion);
    const Normals rest = normals_at_rest(*this, ref, into_rest_frame(moves, ray), hit);
    return {rotate_to_world(moves, ray.time, rest.geometric),
            rotate_to_world(moves, ray.time, rest.shading)};
}

std::size_t Geometry::bytes() const {
    std::size_t total = refs_.size() * sizeof(PrimitiveRef) + bounds_.size() * sizeof(Box) +
                        vertices_.size() * sizeof(vec3) + vertex_normals_.size() * sizeof(vec3) +
                        triangles_.size() * sizeof(triangles_[0]) +
                        spheres_.size() * sizeof(Sphere) + frusta_.size() * sizeof(Frustum) +
                        polygons_.size() * sizeof(Polygon) + motions_.size() * sizeof(Motion);
    for (const Polygon& polygon : polygons_)
        total += (polygon.corners.size() + polygon.normals.size()) * sizeof(vec3);
    return total;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
