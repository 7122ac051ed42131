#pragma once

#include "accel/core/vec.h"

/// How much of unpolarised light a smooth interface reflects (Fresnel 1823; Born & Wolf, sec. 1.5).
namespace rayshoot {

/// A plane between two dielectrics, met from the near one.
struct Refraction {
    float reflectance = 1;         ///< in [0, 1]; 1: total
    float transmitted_cosine = 0;  ///< of the refracted direction with the normal, Snell's law
};

/// `cosine` in [0, 1], `index` = that of the far medium / that of the near one.
Refraction refraction(float cosine, float index);

/// `out` refracted by a facet of `normal` that it is on the side of, at dot(out, normal) = cosine.
inline vec3 refracted(const vec3& out, const vec3& normal, float cosine, float index,
                      float transmitted_cosine) {
    return normal * (cosine / index - transmitted_cosine) - out / index;
}

/// A conductor of complex index eta + i absorption, seen from vacuum; per channel.
vec3 conductor_reflectance(float cosine, const vec3& eta, const vec3& absorption);

}  // namespace rayshoot
