#include "tracer/light/flat_emitter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tracer/bsdf/frame.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {
namespace {

constexpr double pi = std::numbers::pi;

/// Right-handed, as long as twice the area.
dvec3 area_vector(const Triangle& triangle) {
    const dvec3 a(triangle.a);
    return cross(dvec3(triangle.b) - a, dvec3(triangle.c) - a);
}

Triangle triangle_of(const Geometry& geometry, std::uint32_t primitive) {
    return geometry.triangle(geometry.ref(primitive).index);
}

}  // namespace

FlatEmitter::FlatEmitter(const Scene& scene, const Light& light)
    : light_(light), geometry_(scene.geometry), clearance_(geometry_, light.primitives) {
    if (!light.primitives.empty()) {
        const PrimitiveRef& ref = geometry_.ref(light.primitives.front());
        if (ref.motion != no_motion) motion_ = &geometry_.motion(ref.motion);
    }
    if (light.kind == LightKind::triangles) {
        for (const std::uint32_t primitive : light.primitives) {
            area_ += length(area_vector(triangle_of(geometry_, primitive))) / 2;
            cumulative_.push_back(area_);
        }
        return;
    }
    if (light.kind == LightKind::rectangle) {
        across_ = dvec3(light.edge_u);
        down_ = dvec3(light.edge_v);
        area_ = length(cross(across_, down_));
        normal_ = normalised(cross(across_, down_));
        return;
    }
    const FrameOf<double> frame(normalised(dvec3(light.direction)));
    across_ = frame.tangent * double{light.radius};
    down_ = frame.bitangent * double{light.radius};
    normal_ = frame.normal;
    area_ = pi * light.radius * light.radius;
}

FlatEmitter::Spot FlatEmitter::on_light(Pair pair) const {
    const dvec3 origin(light_.position);
    if (light_.kind == LightKind::rectangle)
        return {origin + across_ * double{pair.u} + down_ * double{pair.v}, normal_};
    if (light_.kind == LightKind::disc) {
        const glm::vec2 disc = concentric_disc(pair);
        return {origin + across_ * double{disc.x} + down_ * double{disc.y}, normal_};
    }
    return on_triangles(pair);
}

/// u picks the triangle; what is left of it is uniform again.
FlatEmitter::Spot FlatEmitter::on_triangles(Pair pair) const {
    const double at = pair.u * area_;
    const auto found = std::min(std::ranges::upper_bound(cumulative_, at), cumulative_.end() - 1);
    const auto place = static_cast<std::size_t>(found - cumulative_.begin());
    const double before = place > 0 ? cumulative_[place - 1] : 0;
    const double share = std::clamp((at - before) / (*found - before), 0.0, 1 - 0x1p-24);
    const Triangle triangle = triangle_of(geometry_, light_.primitives[place]);
    const Pair weights = uniform_triangle({static_cast<float>(share), pair.v});
    const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
    return {a + e1 * double{weights.u} + e2 * double{weights.v}, normalised(cross(e1, e2))};
}

FlatEmitter::Spot FlatEmitter::in_world(const Spot& spot, float time) const {
    if (!motion_) return spot;
    return {move_to_world(*motion_, time, spot.position),
            dvec3(rotate_to_world(*motion_, time, vec3(spot.normal)))};
}

double FlatEmitter::density(double distance_squared, double cosine) const {
    return distance_squared / (cosine * area_);
}

std::optional<LightSample> FlatEmitter::sample(const dvec3& from, float time, Pair pair) const {
    const Spot spot = in_world(on_light(pair), time);
    const dvec3 to_light = spot.position - from;
    const double squared = dot(to_light, to_light), distance = std::sqrt(squared);
    const double cosine = -dot(to_light, spot.normal) / distance;
    if (!(cosine > 0)) return std::nullopt;  // NaN: `from` is the point itself
    LightSample sample;
    sample.direction = vec3(to_light / distance);
    sample.distance = static_cast<float>(distance);
    sample.pdf = static_cast<float>(density(squared, cosine));
    sample.incident = light_.intensity * static_cast<float>(1 / density(squared, cosine));
    clearance_.end(sample, from, spot.position, spot.normal);
    return sample;
}

float FlatEmitter::pdf(const dvec3& from, const SurfacePoint& at, float) const {
    const dvec3 to_light = at.position - from;
    const double squared = dot(to_light, to_light);
    const double cosine = -dot(to_light, dvec3(at.geometric)) / std::sqrt(squared);
    return cosine > 0 ? static_cast<float>(density(squared, cosine)) : 0;
}

vec3 FlatEmitter::power(double) const { return light_.intensity * static_cast<float>(pi * area_); }

}  // namespace rayshoot
