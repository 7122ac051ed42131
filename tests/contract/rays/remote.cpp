#include "tests/contract/rays.h"

namespace rayshoot::contract {
namespace {

/// Towards `target` from `sizes` scene sizes away.
Ray from_afar(const vec3& target, float sizes, const Geometry& geometry, float time,
              Random& random) {
    Ray ray;
    const vec3 away = random.direction();
    ray.origin = target + sizes * scene_size(geometry) * away;
    ray.direction = random.coin() ? -away : target - ray.origin;
    ray.time = time;
    return ray;
}

template <int Exponent>
Ray far(const Geometry& geometry, Random& random) {
    constexpr std::array<float, 7> powers{1, 1e1f, 1e2f, 1e3f, 1e4f, 1e5f, 1e6f};
    const Face face = random_face(geometry, random);
    const vec3 target = random.coin() ? face.corners[0] : face.random_point(random);
    return from_afar(target, powers[Exponent], geometry, face.time, random);
}

/// From afar along an axis or a diagonal: all cells of a line tie when their planes round to one t.
Ray far_along_an_axis(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    Ray ray;
    ray.direction = vec3(0);
    ray.direction[static_cast<int>(random.below(3))] = 1;
    if (random.coin()) ray.direction += vec3(1, -1, 1);
    ray.origin = face.corners[0] - 3e6f * scene_size(geometry) * ray.direction;
    ray.time = face.time;
    return ray;
}

/// Directions whose squares leave the range of a float.
Ray long_or_short_direction(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    Ray ray = from_afar(face.random_point(random), 2, geometry, face.time, random);
    ray.direction = vec3(normalised(dvec3(ray.direction)));
    ray.direction *= random.power_of_two(-100, 100);
    return ray;
}

/// The line's part behind the origin counts too when t_min says so.
Ray backward(const Geometry& geometry, Random& random) {
    const Face face = random_face(geometry, random);
    Ray ray = from_afar(face.random_point(random), 1, geometry, face.time, random);
    if (random.coin()) ray.direction = -ray.direction;
    ray.t_min = random.coin() ? -infinity : -3 * scene_size(geometry);
    if (random.coin()) ray.t_max = 0;
    return ray;
}

/// Times that have to be clamped to the shutter.
Ray outside_the_shutter(const Geometry& geometry, Random& random) {
    constexpr std::array<float, 8> times{-1,   -1e30f, -infinity, -0.0f,
                                         1.5f, 1e30f,  infinity,  0x1.000002p0f};
    const Face face = random_face(geometry, random);
    Ray ray = from_afar(face.random_point(random), 1, geometry, face.time, random);
    ray.time = times[random.below(8)];
    return ray;
}

}  // namespace

std::vector<RayFamily> remote_families() {
    return {{"far_1e3", far<3>},
            {"far_1e4", far<4>},
            {"far_1e5", far<5>},
            {"far_1e6", far<6>},
            {"far_along_an_axis", far_along_an_axis},
            {"long_or_short_direction", long_or_short_direction},
            {"backward", backward},
            {"outside_the_shutter", outside_the_shutter}};
}

}  // namespace rayshoot::contract
