#include "tracer/bsdf/conductor.h"

#include "tracer/bsdf/facet_reflection.h"
#include "tracer/bsdf/fresnel.h"

namespace rayshoot {

Conductor::Conductor(const vec3& tint, const vec3& eta, const vec3& absorption, float roughness)
    : tint_(tint),
      eta_(eta),
      absorption_(absorption),
      facets_{roughness},
      smooth_(roughness < smallest_roughness) {}

vec3 Conductor::reflectance(float cosine) const {
    return tint_ * conductor_reflectance(cosine, eta_, absorption_);
}

vec3 Conductor::evaluate(const vec3& out, const vec3& in) const {
    if (smooth_) return vec3(0);
    const auto reflection = facet_reflection(facets_, out, in);
    return reflection ? reflectance(reflection->cosine) * reflection->scattered : vec3(0);
}

float Conductor::pdf(const vec3& out, const vec3& in) const {
    if (smooth_) return 0;
    const auto reflection = facet_reflection(facets_, out, in);
    return reflection ? reflection->density : 0;
}

std::optional<LobeSample> Conductor::sample(const vec3& out, float, Pair pair) const {
    if (smooth_) return LobeSample{mirrored(out), reflectance(out.z), 0, true};
    const vec3 in = reflected(out, facets_.visible_normal(out, pair));
    const auto reflection = facet_reflection(facets_, out, in);
    if (!reflection || !(reflection->density > 0)) return std::nullopt;
    return LobeSample{in, reflectance(reflection->cosine) * reflection->weight(),
                      reflection->density};
}

}  // namespace rayshoot
