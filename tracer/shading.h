#pragma once

#include <cstdint>
#include <optional>

#include "data/scene.h"
#include "tracer/light/light_sample.h"
#include "tracer/sampling/pair.h"
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
    float time = 0;  ///< of the ray that hit; rays that are sent on have it too
    vec3 incoming;   ///< of the ray that hit
    vec3 normal;     ///< shading normal that decides on light: see Rules
    const Material* material = nullptr;
    Rules rules = Rules::spd_readme;
};

Shade make_shade(const Scene& scene, Rules rules, const Ray& ray, const Hit& hit);

/// Light that comes from everywhere: sqrt(lights) / (2 lights), the SPD Readme's suggestion.
vec3 ambient(const Scene& scene, const Material& material);

/// A shadow ray and what the eye sees of its light when nothing is in between.
struct Illumination {
    Ray ray;
    vec3 radiance;
};

/// Of a light that is a point, spot or direction and does not fall off (Phong 1975): diffuse and
/// highlight. Empty when the normal points away from the light.
std::optional<Illumination> illumination(const Shade& shade, const Light& light);
/// Of a sample of any light; light of irradiance pi is what an intensity of 1 is above.
/// `highlight`: left out where reflected rays can meet the lamp itself.
std::optional<Illumination> illumination(const Shade& shade, const LightSample& sample,
                                         bool highlight);

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

/// Where in its lobe a blurred ray goes, if the material's gloss blurs any.
struct Blur {
    Pair reflection, refraction;
};

/// Blurred rays that would leave to the wrong side of the surface are left out.
Spawned spawned_rays(const Shade& shade, const Blur& blur = {});

/// Whether the first illumination() is meant for it.
bool without_falloff(const Light& light);

}  // namespace rayshoot
