#include "accel/core/promise.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr float cell_slack = 1e-3f;  // cells: rounding of the caller's ray; not the structure's
constexpr float lens_slack = 1e-3f;  // share of its radius

/// How far the rounding of a ray's origin, and of moving it to the rest frame, may put it off.
float origin_rounding(const View& view, const Ray& ray) {
    return 0x1p-22f * (taxicab(ray.origin) + taxicab(view.eye));
}

std::string raster_promise(const View& view, const vec3& in_focus, Source source, float slack) {
    const vec3 in_raster = in_focus - view.to_corner;
    const float x = dot(in_raster, view.across) / dot(view.across, view.across);
    const float y = dot(in_raster, view.down) / dot(view.down, view.down);
    const float cell_x = source.cell_x(), cell_y = source.cell_y();
    if (x < cell_x - slack || x > cell_x + 1 + slack || y < cell_y - slack ||
        y > cell_y + 1 + slack)
        return "a camera ray goes through raster point (" + std::to_string(x) + ", " +
               std::to_string(y) + "), not through its cell (" + std::to_string(source.cell_x()) +
               ", " + std::to_string(source.cell_y()) + ")";
    return {};
}

bool in_border(const View& view, Source source) {
    const auto within = [&](int cell, int cells) {
        return cell >= -view.border && cell < cells + view.border;
    };
    return within(source.cell_x(), view.width) && within(source.cell_y(), view.height);
}

std::string camera_promise(const View& view, const Ray& ray, Source source) {
    if (!in_border(view, source))
        return "a camera ray names cell (" + std::to_string(source.cell_x()) + ", " +
               std::to_string(source.cell_y()) + "), beyond the border of " +
               std::to_string(view.border) + " cells";
    Ray at_rest = ray;
    if (view.motion) at_rest = into_rest_frame(*view.motion, ray);
    const vec3 from_eye = at_rest.origin - view.eye;
    const float rounding = origin_rounding(view, ray);
    if (length(from_eye) > view.lens_radius * (1 + lens_slack) + rounding)
        return "a camera ray starts " + std::to_string(length(from_eye)) +
               " from the eye, not on the lens of radius " + std::to_string(view.lens_radius);
    // Where the ray meets the focal plane, as a direction from the eye whose forward part is 1.
    const float depth = dot(from_eye, view.forward), speed = dot(at_rest.direction, view.forward);
    if (!(speed > 0)) return "a camera ray does not look forward";
    const float t = (view.focus_distance - depth) / speed;
    const vec3 in_focus = along(from_eye, t, at_rest.direction) / view.focus_distance;
    const float cell = std::min(length(view.across), length(view.down));
    const float moved = view.motion ? rounding / (view.focus_distance * cell) : 0;
    return raster_promise(view, in_focus, source, cell_slack + moved);
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
