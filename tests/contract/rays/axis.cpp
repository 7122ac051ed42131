#include "tests/contract/rays.h"

namespace rayshoot::contract {
namespace {

float signed_zero(Random& random) { return random.coin() ? 0.0f : -0.0f; }

int any_axis(Random& random) { return static_cast<int>(random.below(3)); }

/// Along one axis, the other two components +0 or -0.
vec3 axis_direction(Random& random) {
    vec3 direction;
    for (int axis = 0; axis < 3; ++axis) direction[axis] = signed_zero(random);
    direction[any_axis(random)] = random.coin() ? 1.0f : -1.0f;
    return direction;
}

/// Back along the direction by some scene sizes, exact where the direction is a unit or zero.
vec3 backed_off(const vec3& target, const vec3& direction, float distance) {
    vec3 origin = target;
    for (int axis = 0; axis < 3; ++axis)
        if (direction[axis] != 0) origin[axis] -= distance * direction[axis];
    return origin;
}

Ray ray_of(const vec3& origin, const vec3& direction, float time) {
    Ray ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.time = time;
    return ray;
}

Ray axis_parallel_at_a_vertex(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const vec3 direction = axis_direction(random);
    const float distance = scene_size(geometry) * random.between(-1, 2);
    return ray_of(backed_off(face.corners[0], direction, distance), direction, face.time);
}

Ray axis_parallel_at_a_face(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    const vec3 target = face.random_point(random);
    const float scale = random.power_of_two(-10, 10);
    const vec3 direction = axis_direction(random) * scale;
    return ray_of(backed_off(target, direction, random.between(-1, 2)), direction, face.time);
}

Ray with_a_zero_component(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    vec3 direction = random.direction();
    direction[any_axis(random)] = signed_zero(random);
    const vec3 target = random.coin() ? face.corners[0] : face.random_point(random);
    const float distance = scene_size(geometry) * random.between(-1, 2);
    return ray_of(backed_off(target, direction, distance), direction, face.time);
}

/// Runs inside a plane of some primitive's bounds, where the slab test meets 0 * infinity.
Ray in_a_plane_of_bounds(const Geometry& geometry, Random& random) {
    if (geometry.size() == 0) return axis_parallel_at_a_vertex(geometry, random);
    const std::uint32_t primitive = random.below(geometry.size());
    const Box& bounds = random.coin() ? geometry.bounds() : geometry.bounds(primitive);
    vec3 origin = random.inside(bounds.empty() ? Box{vec3(0), vec3(1)} : bounds);
    const int axis = any_axis(random);
    origin[axis] = random.coin() ? bounds.lo[axis] : bounds.hi[axis];
    vec3 direction = random.coin() ? random.direction() : axis_direction(random);
    direction[axis] = signed_zero(random);
    if (direction == vec3(0)) direction[(axis + 1) % 3] = 1;
    const float distance = scene_size(geometry) * random.between(0, 2);
    return ray_of(backed_off(origin, direction, distance), direction, random.unit());
}

/// Through corners of boxes along a diagonal: planes of two or three axes at one t.
Ray diagonal(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    vec3 direction;
    for (int axis = 0; axis < 3; ++axis) direction[axis] = random.coin() ? 1.0f : -1.0f;
    if (random.coin()) direction[any_axis(random)] = signed_zero(random);
    const float distance = scene_size(geometry) * random.power_of_two(-2, 3);
    return ray_of(backed_off(face.corners[0], direction, distance), direction, face.time);
}

/// Nearly axis-parallel: components that are tiny, or denormal, against the largest.
Ray nearly_parallel(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    vec3 direction;
    for (int axis = 0; axis < 3; ++axis) {
        direction[axis] = random.power_of_two(-148, -20);
        if (random.coin()) direction[axis] = -direction[axis];
    }
    direction[any_axis(random)] = random.coin() ? 1.0f : -1.0f;
    const float distance = scene_size(geometry) * random.between(-1, 2);
    return ray_of(backed_off(face.corners[0], direction, distance), direction, face.time);
}

}  // namespace

std::vector<RayFamily> axis_families() {
    return {{"axis_parallel_at_a_vertex", axis_parallel_at_a_vertex},
            {"axis_parallel_at_a_face", axis_parallel_at_a_face},
            {"with_a_zero_component", with_a_zero_component},
            {"in_a_plane_of_bounds", in_a_plane_of_bounds},
            {"diagonal", diagonal},
            {"nearly_parallel", nearly_parallel}};
}

}  // namespace rayshoot::contract
