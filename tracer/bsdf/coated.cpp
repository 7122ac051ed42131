#include "tracer/bsdf/coated.h"

#include "tracer/bsdf/facet_reflection.h"
#include "tracer/bsdf/fresnel.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {

CoatedDiffuser::CoatedDiffuser(const vec3& reflectance, float specular, float index,
                               float roughness)
    : reflectance_(reflectance),
      specular_(specular),
      index_(index),
      facets_{roughness},
      smooth_(roughness < smallest_roughness) {}

float CoatedDiffuser::coat(float cosine) const {
    return specular_ * refraction(cosine, index_).reflectance;
}

float CoatedDiffuser::coat_probability(float coat_share) const {
    const float below = (1 - coat_share) * mean(reflectance_);
    return coat_share > 0 ? coat_share / (coat_share + below) : 0;
}

vec3 CoatedDiffuser::diffuse(const vec3& out, const vec3& in) const {
    return reflectance_ * ((1 - coat(out.z)) * (1 - coat(in.z)) * in.z / pi);
}

vec3 CoatedDiffuser::evaluate(const vec3& out, const vec3& in) const {
    if (!(in.z > 0)) return vec3(0);
    const auto reflection = smooth_ ? std::nullopt : facet_reflection(facets_, out, in);
    const float glossy = reflection ? coat(reflection->cosine) * reflection->scattered : 0;
    return diffuse(out, in) + vec3(glossy);
}

float CoatedDiffuser::pdf(const vec3& out, const vec3& in) const {
    if (!(in.z > 0)) return 0;
    const float by_coat = coat_probability(coat(out.z));
    const auto reflection = smooth_ ? std::nullopt : facet_reflection(facets_, out, in);
    return by_coat * (reflection ? reflection->density : 0) +
           (1 - by_coat) * cosine_hemisphere_pdf(in.z);
}

std::optional<LobeSample> CoatedDiffuser::sample(const vec3& out, float choice, Pair pair) const {
    const float share = coat(out.z), by_coat = coat_probability(share);
    const bool at_coat = choice < by_coat;
    if (at_coat && smooth_) return LobeSample{mirrored(out), vec3(share / by_coat), 0, true};
    const vec3 in =
        at_coat ? reflected(out, facets_.visible_normal(out, pair)) : cosine_hemisphere(pair);
    const float density = pdf(out, in);
    if (!(density > 0)) return std::nullopt;
    return LobeSample{in, evaluate(out, in) / density, density};
}

}  // namespace rayshoot
