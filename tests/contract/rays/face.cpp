#include "tests/contract/rays.h"

#include <algorithm>

/// Points of surfaces for rays to be aimed at. Rounding does not matter here: what is aimed at is
/// hit or missed by whatever the shared primitive test says.
namespace rayshoot::contract {
namespace {

vec3 perpendicular(const vec3& axis, Random& random) {
    const vec3 across = normalised(cross(axis, random.direction()));
    return finite(across) ? across : vec3(1, 0, 0);
}

std::array<vec3, 3> corners_of(const Sphere& sphere, Random& random) {
    std::array<vec3, 3> corners;
    for (vec3& corner : corners) corner = sphere.centre + sphere.radius * random.direction();
    corners[0] = sphere.centre;
    corners[0][static_cast<int>(random.below(3))] += random.coin() ? sphere.radius : -sphere.radius;
    return corners;
}

std::array<vec3, 3> corners_of(const Frustum& frustum, Random& random) {
    const vec3 across = perpendicular(frustum.apex - frustum.base, random);
    const vec3 other = perpendicular(frustum.apex - frustum.base, random);
    return {frustum.base + frustum.base_radius * across,
            frustum.apex + frustum.apex_radius * across,
            frustum.base + frustum.base_radius * other};
}

std::array<vec3, 3> corners_of(const Polygon& polygon, Random& random) {
    const auto count = static_cast<std::uint32_t>(polygon.corners.size());
    const std::uint32_t first = random.below(count);
    return {polygon.corners[first], polygon.corners[(first + 1) % count],
            polygon.corners[(first + 2) % count]};
}

std::array<vec3, 3> corners_of(const Geometry& geometry, const PrimitiveRef& ref, Random& random) {
    switch (ref.kind) {
        case PrimitiveKind::triangle: {
            const Triangle t = geometry.triangle(ref.index);
            const std::array<vec3, 3> turned{t.a, t.b, t.c};
            const std::uint32_t first = random.below(3);
            return {turned[first], turned[(first + 1) % 3], turned[(first + 2) % 3]};
        }
        case PrimitiveKind::sphere:
            return corners_of(geometry.sphere(ref.index), random);
        case PrimitiveKind::frustum:
            return corners_of(geometry.frustum(ref.index), random);
        case PrimitiveKind::polygon:
            return corners_of(geometry.polygon(ref.index), random);
    }
    return {};
}

vec3 moved(const Motion& motion, float time, const vec3& point) {
    const vec3 turned = rotate_to_world(motion, time, point - motion.pivot);
    const vec3 shift = (1 - time) * motion.translation[0] + time * motion.translation[1];
    return turned + motion.pivot + shift;
}

}  // namespace

vec3 Face::point(float u, float v) const {
    return corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
}

vec3 Face::random_point(Random& random) const {
    const float u = random.unit();
    return point(u, (1 - u) * random.unit());
}

vec3 Face::normal() const {
    const dvec3 a(corners[0]);
    const dvec3 across = cross(dvec3(corners[1]) - a, dvec3(corners[2]) - a);
    const double size = length(across);
    return size > 0 ? vec3(across / size) : vec3(0);
}

Face random_face(const Geometry& geometry, Random& random) {
    constexpr std::array<float, 4> times{0, 0.5f, 1, 0.3f};
    Face face{.corners = {vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)}, .time = times[random.below(4)]};
    if (geometry.size() == 0) return face;
    const PrimitiveRef& ref = geometry.ref(random.below(geometry.size()));
    face.corners = corners_of(geometry, ref, random);
    if (ref.motion != no_motion)
        for (vec3& corner : face.corners)
            corner = moved(geometry.motion(ref.motion), face.time, corner);
    return face;
}

float scene_size(const Geometry& geometry) {
    if (geometry.size() == 0) return 1;
    const vec3 size = geometry.bounds().size();
    const float largest = std::max({size.x, size.y, size.z});
    return largest > 0 ? largest : 1;
}

}  // namespace rayshoot::contract
