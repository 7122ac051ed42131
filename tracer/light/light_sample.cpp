#include "tracer/light/light_sample.h"

#include <cmath>

namespace rayshoot {

Ray shadow_ray(const SurfacePoint& surface, const LightSample& sample, float time) {
    Ray ray;
    ray.origin = spawn_origin(surface, sample.direction);
    ray.time = time;
    if (std::isinf(sample.distance)) {
        ray.direction = sample.direction;
        return ray;
    }
    ray.direction = vec3(sample.point - dvec3(ray.origin));
    ray.t_max = sample.end;
    return ray;
}

}  // namespace rayshoot
