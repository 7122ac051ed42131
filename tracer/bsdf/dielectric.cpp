#include "tracer/bsdf/dielectric.h"

#include <cmath>

#include "tracer/bsdf/facet_reflection.h"
#include "tracer/bsdf/facet_refraction.h"
#include "tracer/bsdf/fresnel.h"

namespace rayshoot {

Dielectric::Dielectric(const vec3& tint, float index, float roughness)
    : tint_(tint),
      index_(index),
      facets_{roughness},
      smooth_(roughness < smallest_roughness || std::abs(index - 1) < smallest_contrast) {}

/// `in` above the surface, with the density of all that sample() does.
std::optional<LobeSample> Dielectric::reflect(const vec3& out, const vec3& in) const {
    const auto facet = facet_reflection(facets_, out, in);
    if (!facet || !(facet->density > 0)) return std::nullopt;
    const float share = refraction(facet->cosine, index_).reflectance;
    return LobeSample{in, vec3(facet->weight()), share * facet->density};
}

/// The same below.
std::optional<LobeSample> Dielectric::refract(const vec3& out, const vec3& in) const {
    const auto facet = facet_refraction(facets_, index_, out, in);
    if (!facet || !(facet->density > 0)) return std::nullopt;
    const float share = 1 - refraction(facet->cosine, index_).reflectance;
    return LobeSample{in, tint_ * facet->weight(), share * facet->density};
}

vec3 Dielectric::evaluate(const vec3& out, const vec3& in) const {
    if (smooth_) return vec3(0);
    const auto sample = in.z > 0 ? reflect(out, in) : refract(out, in);
    return sample ? sample->weight * sample->pdf : vec3(0);
}

float Dielectric::pdf(const vec3& out, const vec3& in) const {
    if (smooth_) return 0;
    const auto sample = in.z > 0 ? reflect(out, in) : refract(out, in);
    return sample ? sample->pdf : 0;
}

LobeSample Dielectric::sample_smooth(const vec3& out, float choice) const {
    const auto [reflectance, transmitted_cosine] = refraction(out.z, index_);
    if (choice < reflectance) return {mirrored(out), vec3(1), 0, true};
    const vec3 in = refracted(out, {0, 0, 1}, out.z, index_, transmitted_cosine);
    return {in, tint_ / (index_ * index_), 0, true};
}

std::optional<LobeSample> Dielectric::sample(const vec3& out, float choice, Pair pair) const {
    if (smooth_) return sample_smooth(out, choice);
    const vec3 facet = facets_.visible_normal(out, pair);
    const float cosine = dot(out, facet);
    const auto [reflectance, transmitted_cosine] = refraction(cosine, index_);
    if (choice < reflectance) return reflect(out, reflected(out, facet));
    return refract(out, refracted(out, facet, cosine, index_, transmitted_cosine));
}

}  // namespace rayshoot
