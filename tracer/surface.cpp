#include "tracer/surface.h"

#include <algorithm>

namespace rayshoot {
namespace {

constexpr double unit_roundoff = 0x1p-24;  // of float

/// Half-way between rounding and the offsets that rounding must not undo: see README.md.
constexpr double position_factor = 2 * unit_roundoff;  // times taxicab(position)
constexpr double distance_factor = 4 * unit_roundoff;  // times the taxicab distance travelled
constexpr double triangle_factor = 8 * unit_roundoff;  // times edge * edge * edge / area vector
constexpr double sphere_factor = 8 * unit_roundoff;    // times radius
constexpr double frustum_factor = 2 * unit_roundoff;   // times extent
constexpr double motion_factor = 32 * unit_roundoff;   // times the taxicab lengths moved

struct Located {
    dvec3 position;
    double test_error;  ///< of the primitive's test near `position`, without that of its rounding
};

double triangle_error(const Triangle& triangle) {
    const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
    const double first = taxicab(e1), second = taxicab(e2);
    const double area = length(cross(e1, e2));
    return area > 0 ? triangle_factor * (first * second * std::max(first, second) / area) : 0;
}

double frustum_error(const Frustum& frustum) {
    const double radius = std::max(double{frustum.base_radius}, double{frustum.apex_radius});
    return frustum_factor * (taxicab(dvec3(frustum.apex) - dvec3(frustum.base)) + radius);
}

/// The barycentrics name a point of the plane, however wrong they may be within it.
Located on_triangle(const Triangle& triangle, const Hit& hit) {
    const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
    return {a + e1 * double{hit.u} + e2 * double{hit.v}, triangle_error(triangle)};
}

Located on_sphere(const Sphere& sphere, const dvec3& reported) {
    const dvec3 centre(sphere.centre);
    const dvec3 outward = reported - centre;
    const double distance = length(outward);
    const double radius = sphere.radius;
    return {distance > 0 ? centre + outward * (radius / distance) : reported,
            sphere_factor * radius};
}

/// Moves the reported point along its radius to the lateral surface at its height.
Located on_frustum(const Frustum& frustum, const dvec3& reported) {
    const dvec3 base(frustum.base), axis = dvec3(frustum.apex) - base;
    const double axis_squared = dot(axis, axis);
    if (!(axis_squared > 0)) return {reported, frustum_error(frustum)};
    const double height = dot(reported - base, axis) / axis_squared;
    const dvec3 on_axis = base + axis * height;
    const dvec3 outward = reported - on_axis;
    const double distance = length(outward);
    const double radius =
        frustum.base_radius + (double{frustum.apex_radius} - frustum.base_radius) * height;
    return {distance > 0 ? on_axis + outward * (radius / distance) : reported,
            frustum_error(frustum)};
}

Located on_polygon(const Polygon& polygon, const dvec3& reported) {
    const double squared = dot(polygon.normal, polygon.normal);
    if (!(squared > 0)) return {reported, 0};
    const double off = dot(reported - polygon.centre, polygon.normal) / squared;
    return {reported - polygon.normal * off, 0};
}

Located at_rest(const Geometry& geometry, const PrimitiveRef& ref, const Ray& ray, const Hit& hit) {
    const dvec3 reported = dvec3(ray.origin) + double{hit.t} * dvec3(ray.direction);
    switch (ref.kind) {
        case PrimitiveKind::triangle:
            return on_triangle(geometry.triangle(ref.index), hit);
        case PrimitiveKind::sphere:
            return on_sphere(geometry.sphere(ref.index), reported);
        case PrimitiveKind::frustum:
            return on_frustum(geometry.frustum(ref.index), reported);
        case PrimitiveKind::polygon:
            return on_polygon(geometry.polygon(ref.index), reported);
    }
    return {reported, 0};
}

/// A point of the rest frame as the world sees it at `time`.
dvec3 into_world(const Motion& motion, float time, const dvec3& rest) {
    const float clamped = shutter_time(time);
    const vec3 arm(rest - dvec3(motion.pivot));
    const dvec3 translation = dvec3(motion.translation[0]) * (1.0 - clamped) +
                              dvec3(motion.translation[1]) * double{clamped};
    return dvec3(rotate_to_world(motion, clamped, arm)) + dvec3(motion.pivot) + translation;
}

double motion_size(const Motion& motion) {
    return taxicab(dvec3(motion.pivot)) + taxicab(dvec3(motion.translation[0])) +
           taxicab(dvec3(motion.translation[1]));
}

/// Two surfaces nearer to each other than this may have been taken in the wrong order.
double travel_error(const Ray& ray, const dvec3& position) {
    return distance_factor * taxicab(position - dvec3(ray.origin));
}

}  // namespace

SurfacePoint surface_point(const Geometry& geometry, const Ray& ray, const Hit& hit) {
    const PrimitiveRef& ref = geometry.ref(hit.primitive);
    const Normals normals = geometry.normal(ray, hit);
    if (ref.motion == no_motion) {
        const Located found = at_rest(geometry, ref, ray, hit);
        return {found.position, normals.geometric, normals.shading,
                found.test_error + travel_error(ray, found.position) +
                    position_factor * taxicab(found.position)};
    }
    const Motion& motion = geometry.motion(ref.motion);
    const Located found = at_rest(geometry, ref, into_rest_frame(motion, ray), hit);
    const dvec3 position = into_world(motion, ray.time, found.position);
    const double moved = taxicab(position) + taxicab(found.position) + motion_size(motion);
    return {position, normals.geometric, normals.shading,
            found.test_error + travel_error(ray, position) + motion_factor * moved};
}

double resting_error(const Geometry& geometry, std::uint32_t primitive) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    double error = 0;
    if (ref.kind == PrimitiveKind::triangle) error = triangle_error(geometry.triangle(ref.index));
    if (ref.kind == PrimitiveKind::sphere)
        error = sphere_factor * double{geometry.sphere(ref.index).radius};
    if (ref.kind == PrimitiveKind::frustum) error = frustum_error(geometry.frustum(ref.index));
    if (ref.motion == no_motion) return error;
    return error + motion_factor * motion_size(geometry.motion(ref.motion));
}

}  // namespace rayshoot
