#pragma once

#include "accel/core/ray.h"
#include "tracer/surface.h"

/// A direction to light, as seen from a point, and the ray that asks whether anything is in
/// between.
namespace rayshoot {

/// t_max of a ray to a point: the last float before 1.
inline constexpr float just_before = 1 - 0x1p-24f;

struct LightSample {
    dvec3 point{0};           ///< where the shadow ray aims: off the light by its error, towards us
    vec3 direction{0};        ///< unit, to the light
    float distance = 0;       ///< to the light's point, scene units; infinite: directional
    vec3 incident{0};         ///< radiance / pdf; of a light without extent its irradiance at right
                              ///< angles: times f |cos| the contribution
    float pdf = 0;            ///< per solid angle; 0: the light has no extent, no ray can meet it
    float end = just_before;  ///< t_max of the shadow ray; less for lights of needles
};

/// From `surface` to `sample`. It starts beside the surface and ends just before the light's point,
/// so neither the surface nor the light itself is hit; origin + direction is sample.point, rounded,
/// and t_max < 1 unless the light is directional.
Ray shadow_ray(const SurfacePoint& surface, const LightSample& sample, float time);

}  // namespace rayshoot
