#pragma once

#include "tracer/bsdf/lambert.h"
#include "tracer/bsdf/power_lobe.h"

namespace rayshoot {

/// A Lambertian part and a glossy one: reflectance / pi + specular (n + 2) / (2 pi) cos^n
/// (Lafortune & Willems 1994). Where the two reflect more than 1 in a channel, both are scaled
/// down.
class Phong {
public:
    Phong(const vec3& reflectance, float specular, float exponent);

    vec3 evaluate(const vec3& out, const vec3& in) const;
    float pdf(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> sample(const vec3& out, float choice, Pair pair) const;
    bool only_deltas() const { return false; }
    const vec3& reflectance() const { return diffuse_.reflectance(); }

private:
    Lambert diffuse_;
    PowerLobe glossy_;
    float specular_;
    float glossy_probability_;
};
static_assert(Lobe<Phong>);

}  // namespace rayshoot
