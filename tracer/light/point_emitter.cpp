#include "tracer/light/point_emitter.h"

#include <cmath>
#include <numbers>

namespace rayshoot {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

double PointEmitter::spot_share(double cosine) const {
    if (light_.kind != LightKind::spot || cosine >= light_.cos_inner) return 1;
    if (cosine <= light_.cos_outer) return 0;
    return (cosine - light_.cos_outer) / (double{light_.cos_inner} - light_.cos_outer);
}

std::optional<LightSample> PointEmitter::sample(const dvec3& from, float, Pair) const {
    const bool physical = light_.falloff == Falloff::inverse_square;
    LightSample sample;
    if (light_.kind == LightKind::directional) {
        sample.direction = -light_.direction;
        sample.distance = infinity;
        sample.incident = light_.intensity * (physical ? 1 : static_cast<float>(pi));
        return sample;
    }
    const dvec3 to_light = dvec3(light_.position) - from;
    const double distance = length(to_light);
    if (!(distance > 0)) return std::nullopt;
    const dvec3 direction = to_light / distance;
    const double share = spot_share(-dot(direction, dvec3(light_.direction)));
    if (!(share > 0)) return std::nullopt;
    sample.point = dvec3(light_.position);
    sample.direction = vec3(direction);
    sample.distance = static_cast<float>(distance);
    const double arriving = physical ? share / (distance * distance) : share * pi;
    sample.incident = light_.intensity * static_cast<float>(arriving);
    return sample;
}

vec3 PointEmitter::power(double scene_radius) const {
    const bool physical = light_.falloff == Falloff::inverse_square;
    const double section = pi * scene_radius * scene_radius;
    if (light_.kind == LightKind::directional)
        return light_.intensity * static_cast<float>(section * (physical ? 1 : pi));
    const double mean_cosine = (double{light_.cos_inner} + light_.cos_outer) / 2;
    const double solid_angle = light_.kind == LightKind::spot ? 2 * pi * (1 - mean_cosine) : 4 * pi;
    // Without falloff the irradiance is pi intensity on all of the sphere round the scene.
    const double per_angle = physical ? 1 : section;
    return light_.intensity * static_cast<float>(solid_angle * per_angle);
}

}  // namespace rayshoot
