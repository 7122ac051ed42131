#pragma once

#include <cstdint>
#include <optional>

#include "data/scene.h"
#include "tracer/surface.h"

/// The surface model of NFF under the testing rules of the Standard Procedural Databases
/// (Haines 1987, SPD Readme, "Testing Procedures"), and what each hit spawns.
namespace rayshoot {

/// Two readings of those rules, which give different published ray counts.
enum class Rules : std::uint8_t {
    spd_readme,  ///< normals are turned to the ray; spawned rays start at the surface
    havran,      ///< Havran 1999: stored normals decide on shadow rays, also inside glass, and
                 ///< nothing nearer than havran_distance is hit
};

/// Scene units along a ray.
inline constexpr float havran_distance = 0.01f;

/// Everything at a hit that shading needs. Directions are unit vectors.
struct Shade {
    SurfacePoint point;
    vec3 incoming;  ///< of the ray that hit
    vec3 normal;    ///< shading normal that decides on light: see Rules
    const Material* material = nullptr;
    Rules rules = Rules::spd_readme;
};

Shade make_shade(const Scene& scene, Rules rules, const Ray& ray, const Hit& hit);

/// Light that comes from everywhere: sqrt(lights) / (2 lights), the SPD Readme's suggestion.
vec3 ambient(const Scene& scene, const Material& material);

/// A shadow ray and what arrives along it when nothing is in between.
struct Illumination {
    Ray ray;
    vec3 radiance;  ///< towards the eye
};

/// Empty when the normal points away from the light. Phong 1975: diffuse and highlight, no falloff.
std::optional<Illumination> illumination(const Shade& shade, const Light& light);

struct SpawnedRay {
    Ray ray;
    float weight = 0;  ///< its share of what the eye sees
};

/// What a hit sends on: Whitted 1980.
struct Spawned {
    std::optional<SpawnedRay> reflection;  ///< wherever Ks > 0 or T > 0
    std::optional<SpawnedRay> refraction;  ///< by Snell's law where T > 0, unless ...
    bool totally_reflected = false;        ///< ... it is; its share then adds to the reflection's
};

Spawned spawned_rays(const Shade& shade);

/// Throws std::invalid_argument for a light that is not a point, spot or directional one.
void require_simple_lights(const Scene& scene);

}  // namespace rayshoot
