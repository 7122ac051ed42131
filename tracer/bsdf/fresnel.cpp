#include "tracer/bsdf/fresnel.h"

#include <algorithm>
#include <cmath>

namespace rayshoot {
namespace {

float squared(float x) { return x * x; }

float conductor_channel(float cosine, float eta, float absorption) {
    const float cosine2 = cosine * cosine, sine2 = 1 - cosine2;
    // a^2 + b^2 and 2a of a + i b = sqrt((eta + i absorption)^2 - sine^2).
    const float real = eta * eta - absorption * absorption - sine2;
    const float modulus = std::sqrt(real * real + 4 * squared(eta * absorption));
    const float twice_a = 2 * std::sqrt(std::max(0.0f, (modulus + real) / 2));
    const float across = (modulus + cosine2 - twice_a * cosine) /  // polarised across the plane
                         (modulus + cosine2 + twice_a * cosine);
    const float constant = cosine2 * modulus + sine2 * sine2, linear = twice_a * cosine * sine2;
    return across * (1 + (constant - linear) / (constant + linear)) / 2;
}

}  // namespace

Refraction refraction(float cosine, float index) {
    const float sine2 = (1 - cosine * cosine) / (index * index);
    if (sine2 >= 1) return {};
    const float transmitted = std::sqrt(1 - std::max(0.0f, sine2));
    const float across = (cosine - index * transmitted) / (cosine + index * transmitted);
    const float along = (index * cosine - transmitted) / (index * cosine + transmitted);
    return {(across * across + along * along) / 2, transmitted};
}

vec3 conductor_reflectance(float cosine, const vec3& eta, const vec3& absorption) {
    return {conductor_channel(cosine, eta.x, absorption.x),
            conductor_channel(cosine, eta.y, absorption.y),
            conductor_channel(cosine, eta.z, absorption.z)};
}

}  // namespace rayshoot
