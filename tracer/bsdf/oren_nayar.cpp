#include "tracer/bsdf/oren_nayar.h"

#include <algorithm>
#include <cmath>

#include "tracer/sampling/warp.h"

namespace rayshoot {

/// At grazing angles the model's albedo goes to reflectance (A + B / 2), up to 1.5 % too much for
/// small sigma (not said in the paper; README.md). So it is scaled down by what exceeds 1.
OrenNayar::OrenNayar(const vec3& reflectance, float sigma) : reflectance_(reflectance) {
    const float variance = sigma * sigma;
    a_ = 1 - 0.5f * variance / (variance + 0.33f);
    b_ = 0.45f * variance / (variance + 0.09f);
    const float excess = std::max(1.0f, a_ + b_ / 2);
    a_ /= excess;
    b_ /= excess;
}

float OrenNayar::shape(const vec3& out, const vec3& in) const {
    // sin alpha tan beta cos phi = (projections' dot product) / (the larger cosine).
    const float across = out.x * in.x + out.y * in.y;
    return a_ + b_ * std::max(0.0f, across) / std::max(out.z, in.z);
}

vec3 OrenNayar::evaluate(const vec3& out, const vec3& in) const {
    return in.z > 0 ? reflectance_ * (shape(out, in) * in.z / pi) : vec3(0);
}

float OrenNayar::pdf(const vec3&, const vec3& in) const { return cosine_hemisphere_pdf(in.z); }

std::optional<LobeSample> OrenNayar::sample(const vec3& out, float, Pair pair) const {
    const vec3 in = cosine_hemisphere(pair);
    if (!(in.z > 0)) return std::nullopt;
    return LobeSample{in, reflectance_ * shape(out, in), cosine_hemisphere_pdf(in.z)};
}

}  // namespace rayshoot
