#include "tests/contract/rays.h"

/// Rays that come with a promise, and keep it.
namespace rayshoot::contract {
namespace {

/// Through a raster point, from a point of the lens, at a time of the shutter.
Ray camera_ray(const View& view, float x, float y, Random& random) {
    const bool sharp = view.lens_radius == 0;
    const float right = sharp ? 0 : view.lens_radius * random.between(-0.7f, 0.7f);
    const float up = sharp ? 0 : view.lens_radius * random.between(-0.7f, 0.7f);
    const vec3 on_lens = right * view.right + up * view.up;
    const vec3 in_focus = view.direction(x, y) * view.focus_distance;
    Ray ray;
    ray.origin = view.eye + on_lens;
    ray.direction = in_focus - on_lens;
    if (view.motion) {
        ray.time = random.unit();
        const auto& [from, to] = view.motion->translation;  // the camera is shifted, not turned
        ray.origin += (1 - ray.time) * from + ray.time * to;
    }
    return ray;
}

/// Inside the cell, or on its edges and corners.
float in_cell(int cell, Random& random) {
    const float corner = static_cast<float>(cell);
    switch (random.below(4)) {
        case 0:
            return corner;
        case 1:
            return corner + 1;
        default:
            return corner + random.unit();
    }
}

vec3 light_sample(const Light& light, Random& random) {
    if (light.kind == LightKind::rectangle) {
        const float u = random.unit();
        return light.position + u * light.edge_u + random.unit() * light.edge_v;
    }
    if (light.kind == LightKind::sphere) {
        const float radius = light.radius * random.unit();
        return light.position + radius * random.direction();
    }
    return light.position;
}

Ray shadow_ray(const vec3& from, const Light& light, float time, Random& random) {
    Ray ray;
    ray.origin = from;
    ray.time = time;
    if (light.kind == LightKind::directional) {
        ray.direction = -light.direction;
    } else {
        ray.direction = light_sample(light, random) - from;
        ray.t_max = random.coin() ? 1.0f : 0x1.fffffep-1f;
    }
    ray.t_min = random.coin() ? 0.0f : 1e-4f;
    return ray;
}

}  // namespace

SourcedRays camera_rays(const View& view, Random& random) {
    SourcedRays made;
    for (int y = -view.border; y < view.height + view.border; ++y)
        for (int x = -view.border; x < view.width + view.border; ++x) {
            const float at_x = in_cell(x, random);
            made.rays.push_back(camera_ray(view, at_x, in_cell(y, random), random));
            made.source.push_back(
                Source::cell(static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)));
        }
    return made;
}

SourcedRays shadow_rays(const HardScene& scene, Random& random, std::size_t count) {
    SourcedRays made;
    for (std::size_t i = 0; i < count; ++i) {
        const Face face = random_face(scene.geometry, random);
        vec3 from = random.coin() ? face.random_point(random) : face.corners[0];
        if (random.below(4) == 0) from += scene_size(scene.geometry) * random.direction();
        const auto light = static_cast<std::uint32_t>(i % scene.lights.size());
        made.rays.push_back(shadow_ray(from, scene.lights[light], face.time, random));
        made.source.push_back(Source::light(light));
    }
    return made;
}

}  // namespace rayshoot::contract
