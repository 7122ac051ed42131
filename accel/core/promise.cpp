#include "accel/core/promise.h"

#include <cstdio>
#include <cstdlib>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr float cell_slack = 1e-3f;  // cells: rounding of the caller's ray; not the structure's

std::string camera_promise(const View& view, const Ray& ray, Source source) {
    Ray at_rest = ray;
    if (view.motion) at_rest = into_rest_frame(*view.motion, ray);
    const vec3 from_eye = at_rest.origin - view.eye;
    // Where the ray meets the focal plane, as a direction from the eye whose forward part is 1.
    const float depth = dot(from_eye, view.forward), speed = dot(at_rest.direction, view.forward);
    if (!(speed > 0)) return "a camera ray does not look forward";
    const float t = (view.focus_distance - depth) / speed;
    const vec3 in_focus = along(from_eye, t, at_rest.direction) / view.focus_distance;
    const vec3 in_raster = in_focus - view.to_corner;
    const float x = dot(in_raster, view.across) / dot(view.across, view.across);
    const float y = dot(in_raster, view.down) / dot(view.down, view.down);
    const float cell_x = source.cell_x(), cell_y = source.cell_y();
    if (x < cell_x - cell_slack || x > cell_x + 1 + cell_slack || y < cell_y - cell_slack ||
        y > cell_y + 1 + cell_slack)
        return "a camera ray goes through raster point (" + std::to_string(x) + ", " +
               std::to_string(y) + "), not through its cell (" + std::to_string(source.cell_x()) +
               ", " + std::to_string(source.cell_y()) + ")";
    return {};
}

std::string shadow_promise(std::span<const Light> lights, const Ray& ray, Source source) {
    if (source.bits >= lights.size())
        return "a shadow ray names light " + std::to_string(source.bits) + " of " +
               std::to_string(lights.size());
    const Light& light = lights[source.bits];
    if (light.kind == LightKind::directional) {
        const float cosine = dot(ray.direction, light.direction) / length(ray.direction);
        return cosine < -0.999f ? "" : "a shadow ray does not run against its directional light";
    }
    if (!(ray.t_max <= 1)) return "a shadow ray goes on behind its light (t_max > 1)";
    const vec3 aim = ray.origin + ray.direction;
    const float slack = 0x1p-18f * (taxicab(ray.origin) + taxicab(aim));
    if (!light.samples.empty() && !light.samples.grown(slack).contains(aim))
        return "a shadow ray does not aim at a sample of its light " + std::to_string(source.bits);
    return {};
}

}  // namespace

std::string broken_promise(const BuildInput& input, const RayBatch& batch) {
    for (std::size_t i = 0; i < batch.source.size(); ++i) {
        const Ray& ray = batch.rays[i];
        if (!answerable(ray)) continue;
        std::string promise;
        if (batch.kind == RayKind::camera && input.view)
            promise = camera_promise(*input.view, ray, batch.source[i]);
        else if (batch.kind == RayKind::shadow && !input.lights.empty())
            promise = shadow_promise(input.lights, ray, batch.source[i]);
        if (!promise.empty()) return promise;
    }
    return {};
}

void stop_for(const std::string& promise) {
    std::fprintf(stderr, "rayshoot: broken promise: %s\n", promise.c_str());
    std::abort();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
