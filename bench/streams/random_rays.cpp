#include "bench/streams/random_rays.h"

#include "bench/statistics/random.h"

#include <algorithm>

namespace rayshoot {
namespace {

/// A box to take points from, never flat and never empty.
Box roomy(const Box& bounds) {
    Box box = bounds.empty() ? Box{vec3{-1}, vec3{1}} : bounds;
    const vec3 size = box.size();
    const float largest = std::max({size.x, size.y, size.z, 1e-20f});
    box.lo -= 0.1f * largest;
    box.hi += 0.1f * largest;
    return box;
}

vec3 point_in(const Box& box, Sequence& random) {
    vec3 point;
    for (int axis = 0; axis < 3; ++axis) {
        const float share = random.unit();
        point[axis] = (1 - share) * box.lo[axis] + share * box.hi[axis];
    }
    return point;
}

class RaySource {
public:
    RaySource(const Geometry& geometry, std::uint64_t seed)
        : geometry_(geometry), box_(roomy(geometry.bounds())), random_(seed) {}

    Ray ray(std::size_t number) {
        const vec3 from = point_in(box_, random_);
        const vec3 to = point_in(box_, random_);
        Ray ray;
        ray.time = random_.unit();
        ray.origin = from;
        ray.direction = to - from;
        switch (number % 6) {
            case 0:
                ray.origin = from - 4.0f * (to - from);
                break;  // a chord, from outside
            case 1:
                ray.origin = from - 1000.0f * (to - from);
                break;  // from far away
            case 2:
                break;  // from inside
            case 3:
                along_an_axis(ray);
                break;
            case 4:
                from_a_primitive(ray);
                break;
            default:
                limited(ray);
                break;
        }
        return ray;
    }

private:
    void along_an_axis(Ray& ray) {
        const auto axis = static_cast<int>(random_.below(3));
        ray.direction = vec3{0};
        ray.direction[axis] = random_.below(2) == 0 ? 1.0f : -1.0f;
        ray.origin[axis] = ray.direction[axis] > 0 ? 2 * box_.lo[axis] - box_.hi[axis]
                                                   : 2 * box_.hi[axis] - box_.lo[axis];
    }
    void from_a_primitive(Ray& ray) {
        if (geometry_.size() == 0) return;
        const auto primitive = static_cast<std::uint32_t>(random_.below(geometry_.size()));
        ray.origin = point_in(geometry_.bounds(primitive), random_);
    }
    void limited(Ray& ray) {
        ray.t_min = 0.5f * random_.unit();
        ray.t_max = ray.t_min + random_.unit();
    }

    const Geometry& geometry_;
    Box box_;
    Sequence random_;
};

}  // namespace

RayStream hostile_rays(const Geometry& geometry, std::size_t count, std::uint64_t seed) {
    RayStream stream;
    RaySource source(geometry, seed);
    stream.rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) stream.rays.push_back(source.ray(i));
    return stream;
}

}  // namespace rayshoot
