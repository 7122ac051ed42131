#include "tests/contract/rays.h"

#include <cmath>

namespace rayshoot::contract {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// A ray that would hit the middle of most scenes, with one field made bad.
template <class Spoil>
Ray spoilt(Spoil&& spoil) {
    Ray ray;
    ray.origin = vec3(0.25f, 0.25f, -5);
    ray.direction = vec3(0, 0, 1);
    spoil(ray);
    return ray;
}

Ray limited(Ray ray, float t, std::uint32_t way) {
    const float before = std::nextafter(t, -infinity), after = std::nextafter(t, infinity);
    switch (way) {
        case 0:
            ray.t_max = before;
            break;
        case 1:
            ray.t_max = t;
            break;
        case 2:
            ray.t_max = after;
            break;
        case 3:
            ray.t_min = before;
            break;
        case 4:
            ray.t_min = t;
            break;
        case 5:
            ray.t_min = after;
            break;
        case 6:
            ray.t_min = before, ray.t_max = after;
            break;
        default:
            ray.t_min = -infinity, ray.t_max = after;
            break;
    }
    return ray;
}

}  // namespace

std::vector<Ray> invalid_rays() {
    std::vector<Ray> rays;
    for (int axis = 0; axis < 3; ++axis)
        for (const float bad : {not_a_number, infinity, -infinity}) {
            rays.push_back(spoilt([&](Ray& ray) { ray.origin[axis] = bad; }));
            rays.push_back(spoilt([&](Ray& ray) { ray.direction[axis] = bad; }));
        }
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = not_a_number; }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_max = not_a_number; }));
    rays.push_back(spoilt([](Ray& ray) { ray.time = not_a_number; }));
    rays.push_back(spoilt([](Ray& ray) { ray.direction = vec3(0); }));
    rays.push_back(spoilt([](Ray& ray) { ray.direction = vec3(-0.0f, 0, -0.0f); }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = ray.t_max = 5; }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = 6, ray.t_max = 5; }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = ray.t_max = infinity; }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = ray.t_max = -infinity; }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = infinity, ray.t_max = -infinity; }));
    rays.push_back(spoilt([](Ray& ray) { ray.t_min = 0.0f, ray.t_max = -0.0f; }));
    return rays;
}

std::vector<Ray> limited_rays(std::span<const Ray> rays, std::span<const Hit> hits, Random& random,
                              std::size_t at_most) {
    std::vector<Ray> limited_ones;
    for (std::size_t i = 0; i < rays.size() && limited_ones.size() < at_most; ++i) {
        if (hits[i].primitive == no_primitive) continue;
        limited_ones.push_back(limited(rays[i], hits[i].t, random.below(4)));
        limited_ones.push_back(limited(rays[i], hits[i].t, 4 + random.below(4)));
    }
    return limited_ones;
}

}  // namespace rayshoot::contract
