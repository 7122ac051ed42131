#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "data/scene.h"
#include "tracer/light/light_sample.h"
#include "tracer/surface.h"

/// The surface model of NFF under the testing rules of the Standard Procedural Databases
/// (Haines 1987, SPD Readme, "Testing Procedures"), and the rays that hits send on. Inline: a hit
/// costs little more than the calls would.
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
    float time = 0;    ///< of the ray that hit; rays that are sent on have it too
    vec3 incoming{0};  ///< of the ray that hit
    vec3 normal{0};    ///< shading normal that decides on light: see Rules
    const Material* material = nullptr;
    Rules rules = Rules::spd_readme;
};

inline Shade make_shade(const Scene& scene, Rules rules, const Ray& ray, const Hit& hit) {
    Shade shade{.point = surface_point(scene.geometry, ray, hit),
                .time = ray.time,
                .incoming = normalised(ray.direction),
                .material = &scene.material(hit.primitive),
                .rules = rules};
    const bool from_behind = dot(shade.incoming, shade.point.geometric) > 0;
    const bool turned = from_behind && rules == Rules::spd_readme;
    shade.normal = turned ? -shade.point.shading : shade.point.shading;
    return shade;
}

/// A ray from there. `distance_per_t`: length of `direction`.
inline Ray spawned(const Shade& shade, const vec3& direction, float t_max = infinity,
                   float distance_per_t = 1) {
    if (shade.rules == Rules::havran) {
        return {vec3(shade.point.position), havran_distance / distance_per_t, direction, t_max,
                shade.time};
    }
    return {spawn_origin(shade.point, direction), 0, direction, t_max, shade.time};
}

inline vec3 mirrored(const vec3& direction, const vec3& normal) {
    return direction - normal * (2 * dot(direction, normal));
}

/// Snell's law at a surface seen from `incoming`; empty when totally reflected.
inline std::optional<vec3> refracted(const Shade& shade) {
    const vec3 stored = shade.point.shading;
    const float index =
        shade.material->refraction_index > 0 ? shade.material->refraction_index : 1.0f;
    const bool entering = dot(shade.incoming, shade.point.geometric) < 0;
    const vec3 normal = entering ? stored : -stored;
    const float ratio = entering ? 1 / index : index;
    const float cosine = -dot(shade.incoming, normal);
    const float squared = 1 - ratio * ratio * (1 - cosine * cosine);
    if (squared < 0) return std::nullopt;
    return normalised(shade.incoming * ratio + normal * (ratio * cosine - std::sqrt(squared)));
}

/// Light that comes from everywhere: sqrt(lights) / (2 lights), the SPD Readme's suggestion.
class Ambient {
public:
    explicit Ambient(const Scene& scene)
        : lights_(static_cast<float>(scene.lights.empty() ? 1 : scene.lights.size())),
          root_(std::sqrt(lights_)) {}

    /// What of it a surface sends back.
    vec3 reflected(const Material& material) const {
        return material.colour * (material.diffuse * root_ / (2 * lights_));
    }

private:
    float lights_, root_;
};

inline vec3 diffuse(const Material& material, float cosine) {
    return material.colour * (material.diffuse * cosine);
}

/// Phong 1975. In double, so that rounding hides which libm computed it.
inline float highlight(const Shade& shade, const vec3& to_light) {
    const Material& material = *shade.material;
    if (!(material.specular > 0)) return 0;
    const float cosine = dot(mirrored(shade.incoming, shade.normal), to_light);
    if (!(cosine > 0)) return 0;
    return material.specular *
           static_cast<float>(std::pow(double{cosine}, double{material.shininess}));
}

/// Share of a spot light's intensity in `direction` (unit, from the light).
inline float spot_share(const Light& light, const vec3& direction) {
    const float cosine = dot(light.direction, direction);
    if (cosine >= light.cos_inner) return 1;
    if (cosine <= light.cos_outer) return 0;
    return (cosine - light.cos_outer) / (light.cos_inner - light.cos_outer);
}

/// A shadow ray and what the eye sees of its light when nothing is in between.
struct Illumination {
    Ray ray;
    vec3 radiance;
};

/// Of a light that is a point, spot or direction and does not fall off (Phong 1975): diffuse and
/// highlight. Empty when the normal points away from the light.
inline std::optional<Illumination> illumination(const Shade& shade, const Light& light) {
    const bool directional = light.kind == LightKind::directional;
    const vec3 to_light =
        directional ? -light.direction : vec3(dvec3(light.position) - shade.point.position);
    const float distance = length(to_light);
    const vec3 unit = to_light / distance;
    const float cosine = dot(shade.normal, unit);
    if (!(cosine > 0)) return std::nullopt;

    Ray ray = spawned(shade, to_light, infinity, distance);
    if (!directional) {
        // From where the ray really starts, so that it ends in the light; t_max stays below 1.
        ray.direction = vec3(dvec3(light.position) - dvec3(ray.origin));
        ray.t_max = 1 - 0x1p-24f;
    }
    const float share = light.kind == LightKind::spot ? spot_share(light, -unit) : 1.0f;
    return Illumination{ray, light.intensity * share *
                                 (diffuse(*shade.material, cosine) + vec3(highlight(shade, unit)))};
}

/// Of a sample of any light; light of irradiance pi is what an intensity of 1 is above.
/// `with_highlight`: left out where reflected rays can meet the lamp itself.
inline std::optional<Illumination> illumination(const Shade& shade, const LightSample& sample,
                                                bool with_highlight) {
    const float cosine = dot(shade.normal, sample.direction);
    if (!(cosine > 0)) return std::nullopt;
    vec3 reflected = diffuse(*shade.material, cosine);
    // A highlight is no irradiance: it does not fall off with the cosine to the light's direction.
    if (with_highlight) reflected += vec3(highlight(shade, sample.direction));
    return Illumination{shadow_ray(shade.point, sample, shade.time),
                        sample.incident * std::numbers::inv_pi_v<float> * reflected};
}

/// Whether the first illumination() is meant for it.
inline bool without_falloff(const Light& light) {
    const bool simple = light.kind == LightKind::point || light.kind == LightKind::spot ||
                        light.kind == LightKind::directional;
    return simple && light.falloff == Falloff::none;
}

}  // namespace rayshoot
