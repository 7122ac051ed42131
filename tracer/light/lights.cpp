#include "tracer/light/lights.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tracer/bsdf/lobe.h"
#include "tracer/light/require_valid.h"

namespace rayshoot {
namespace {

/// Of the ball round everything.
double scene_radius(const Scene& scene) {
    const Box& box = scene.geometry.bounds();
    return box.empty() ? 1 : length(dvec3(box.hi) - dvec3(box.lo)) / 2;
}

}  // namespace

Lights::Lights(const Scene& scene) : scene_(scene) {
    for (const Light& light : scene.lights) {
        require_valid(light, scene);
        emitters_.push_back(emitter(scene, light));
    }
    own_primitives();
    weigh();
}

void Lights::own_primitives() {
    for (std::uint32_t light = 0; light < size(); ++light) {
        for (const std::uint32_t primitive : scene_.lights[light].primitives) {
            light_of_.resize(scene_.geometry.size(), no_light);
            if (light_of_[primitive] != no_light) {
                throw std::invalid_argument("lights " + std::to_string(light_of_[primitive]) +
                                            " and " + std::to_string(light) +
                                            " both shine from primitive " +
                                            std::to_string(primitive) + "; give it to one");
            }
            light_of_[primitive] = light;
        }
    }
}

/// Power by the mean of the channels; alike for all where none has any.
void Lights::weigh() {
    const double radius = scene_radius(scene_);
    double sum = 0;
    std::vector<double> powers;
    for (const Emitter& emitter : emitters_) {
        const vec3 power =
            std::visit([&](const auto& kind) { return kind.power(radius); }, emitter);
        powers.push_back(mean(power));
        sum += powers.back();
    }
    double before = 0;
    for (const double power : powers) {
        const double share = sum > 0 ? power / sum : 1.0 / size();
        before += share;
        probabilities_.push_back(static_cast<float>(share));
        cumulative_.push_back(static_cast<float>(before));
    }
}

std::optional<LightSample> Lights::sample(std::uint32_t light, const dvec3& from, float time,
                                          Pair pair) const {
    return std::visit([&](const auto& kind) { return kind.sample(from, time, pair); },
                      emitters_[light]);
}

float Lights::pdf(std::uint32_t light, const dvec3& from, const SurfacePoint& at,
                  float time) const {
    return std::visit([&](const auto& kind) { return kind.pdf(from, at, time); }, emitters_[light]);
}

Lights::Choice Lights::choose(float u) const {
    if (emitters_.empty()) return {};
    // The first whose sum exceeds u has a probability of its own; rounding may leave u beyond all.
    auto found = std::ranges::upper_bound(cumulative_, u);
    if (found == cumulative_.end())
        found = std::ranges::lower_bound(cumulative_, cumulative_.back());
    const auto light = static_cast<std::uint32_t>(found - cumulative_.begin());
    return {light, probabilities_[light]};
}

vec3 Lights::emitted(std::uint32_t primitive, const SurfacePoint& at, const vec3& direction) const {
    const std::uint32_t light = light_of(primitive);
    const vec3& radiance =
        light == no_light ? scene_.material(primitive).emission : scene_.lights[light].intensity;
    const bool both_sides = scene_.geometry.ref(primitive).kind == PrimitiveKind::sphere;
    return both_sides || dot(at.geometric, direction) > 0 ? radiance : vec3(0);
}

}  // namespace rayshoot
