#include "tracer/bsdf/phong.h"

namespace rayshoot {

Phong::Phong(const vec3& reflectance, float specular, float exponent)
    : diffuse_(reflectance * energy_limit(largest(reflectance) + specular)),
      glossy_{exponent},
      specular_(specular * energy_limit(largest(reflectance) + specular)) {
    const float total = mean(diffuse_.reflectance()) + specular_;
    glossy_probability_ = total > 0 ? specular_ / total : 0;
}

vec3 Phong::evaluate(const vec3& out, const vec3& in) const {
    return diffuse_.evaluate(out, in) + vec3(specular_ * glossy_.evaluate(out, in));
}

float Phong::pdf(const vec3& out, const vec3& in) const {
    return glossy_probability_ * glossy_.pdf(out, in) +
           (1 - glossy_probability_) * diffuse_.pdf(out, in);
}

std::optional<LobeSample> Phong::sample(const vec3& out, float choice, Pair pair) const {
    const vec3 in =
        choice < glossy_probability_ ? glossy_.sample(out, pair) : cosine_hemisphere(pair);
    const float density = pdf(out, in);
    if (!(in.z > 0) || !(density > 0)) return std::nullopt;
    return LobeSample{in, evaluate(out, in) / density, density};
}

}  // namespace rayshoot
