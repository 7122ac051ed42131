#include "tracer/light/sphere_emitter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/bsdf/frame.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {
namespace {

/// A point as near to the surface as this may be of the surface itself, which does not light itself
/// from outside. SurfacePoint knows the place in double; but of movers by their rotation in float.
constexpr double surface_slack = 0x1p-36;  // of the radius

}  // namespace

SphereEmitter::SphereEmitter(const Scene& scene, const Light& light)
    : light_(light), clearance_(scene.geometry, light.primitives) {
    if (light.primitives.empty()) return;
    const PrimitiveRef& ref = scene.geometry.ref(light.primitives.front());
    if (ref.motion != no_motion) motion_ = &scene.geometry.motion(ref.motion);
}

dvec3 SphereEmitter::centre(float time) const {
    const dvec3 at_rest(light_.position);
    return motion_ ? move_to_world(*motion_, time, at_rest) : at_rest;
}

/// On the surface the far end is met through the sphere: what lies above the surface there sees
/// none of it, what lies below all that a hemisphere holds.
SphereEmitter::Aspect SphereEmitter::aspect(const dvec3& from, const dvec3& centre) const {
    const dvec3 axis = centre - from;
    const double radius = light_.radius, distance_squared = dot(axis, axis);
    const double sine_squared = radius * radius / distance_squared;
    const double slack = motion_ ? clearance_.at(centre) / radius : surface_slack;
    if (std::abs(sine_squared - 1) <= 2 * slack) return {1, true};
    if (sine_squared < 1) return {cap_height(sine_squared), false};
    return {2, true};
}

std::optional<LightSample> SphereEmitter::sample(const dvec3& from, float time, Pair pair) const {
    const dvec3 middle = centre(time), axis = middle - from;
    const auto [height, far_end] = aspect(from, middle);
    const double distance = length(axis), radius = light_.radius;
    const dvec3 unit_axis = distance > 0 ? axis / distance : dvec3(0, 0, 1);
    const dvec3 direction =
        normalised(FrameOf<double>(unit_axis).to_world(dvec3(uniform_cone(pair, height))));

    const double nearest = dot(axis, direction);
    const dvec3 off_axis = axis - direction * nearest;
    const double half_chord = std::sqrt(std::max(0.0, radius * radius - dot(off_axis, off_axis)));
    const double t = far_end ? nearest + half_chord : nearest - half_chord;
    const dvec3 outward = normalised(from + direction * t - middle);
    const dvec3 position = middle + outward * radius, to_light = position - from;
    if (!(dot(to_light, to_light) > 0)) return std::nullopt;

    LightSample sample;
    sample.direction = vec3(normalised(to_light));
    sample.distance = static_cast<float>(length(to_light));
    sample.pdf = uniform_cone_pdf(height);
    sample.incident = light_.intensity / sample.pdf;
    clearance_.end(sample, from, position, far_end ? -outward : outward);
    return sample;
}

/// From outside the side that is turned away is never sampled.
float SphereEmitter::pdf(const dvec3& from, const SurfacePoint& at, float time) const {
    const auto [height, far_end] = aspect(from, centre(time));
    const bool turned_here = dot(at.position - from, dvec3(at.geometric)) < 0;
    return far_end || turned_here ? uniform_cone_pdf(height) : 0;
}

vec3 SphereEmitter::power(double) const {
    const double area = 4 * std::numbers::pi * light_.radius * light_.radius;
    return light_.intensity * static_cast<float>(std::numbers::pi * area);
}

}  // namespace rayshoot
