#pragma once

#include "tracer/bsdf/lobe.h"

namespace rayshoot {

/// A surface of Lambertian V-grooves whose slopes have standard deviation sigma (Oren & Nayar 1994,
/// the qualitative model): f = reflectance / pi (A + B max(0, cos phi) sin alpha tan beta), phi
/// between the two directions about the normal, alpha the larger and beta the smaller of their
/// angles with it. Sampled by the cosine.
class OrenNayar {
public:
    /// `sigma` in radians, [0, pi / 2]; 0 is Lambert.
    OrenNayar(const vec3& reflectance, float sigma);

    vec3 evaluate(const vec3& out, const vec3& in) const;
    float pdf(const vec3& out, const vec3& in) const;
    std::optional<LobeSample> sample(const vec3& out, float choice, Pair pair) const;
    bool only_deltas() const { return false; }

private:
    /// f / (cosine density), alike for every channel.
    float shape(const vec3& out, const vec3& in) const;

    vec3 reflectance_;
    float a_, b_;
};
static_assert(Lobe<OrenNayar>);

}  // namespace rayshoot
