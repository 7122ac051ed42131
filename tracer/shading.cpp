#include "tracer/shading.h"

#include <cmath>
#include <numbers>

#include "tracer/bsdf/gloss.h"

namespace rayshoot {
namespace {

vec3 mirrored(const vec3& direction, const vec3& normal) {
    return direction - normal * (2 * dot(direction, normal));
}

Ray spawned(const Shade& shade, const vec3& direction, float t_max, float distance_per_t) {
    Ray ray;
    ray.direction = direction;
    ray.t_max = t_max;
    ray.time = shade.time;
    if (shade.rules == Rules::havran) {
        ray.origin = vec3(shade.point.position);
        ray.t_min = havran_distance / distance_per_t;
    } else {
        ray.origin = spawn_origin(shade.point, direction);
    }
    return ray;
}

/// In the direction of a perfect mirror or glass, or round it where the material blurs.
std::optional<SpawnedRay> sent_on(const Shade& shade, const vec3& sharp, Pair blur, float share) {
    const float gloss = shade.material->gloss;
    if (!(gloss > 0)) return SpawnedRay{spawned(shade, sharp, infinity, 1), share};
    const BlurredRay ray = blurred(sharp, shade.point, gloss, blur);
    if (!(ray.weight > 0)) return std::nullopt;
    return SpawnedRay{spawned(shade, ray.direction, infinity, 1), share * ray.weight};
}

/// Snell's law at a surface seen from `incoming`; empty when totally reflected.
std::optional<vec3> refracted(const Shade& shade) {
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

/// cosine ^ exponent for a highlight; in double, so that rounding hides which libm computed it.
float lobe(float cosine, float exponent) {
    if (!(cosine > 0)) return 0;
    return static_cast<float>(std::pow(double{cosine}, double{exponent}));
}

vec3 diffuse(const Material& material, float cosine) {
    return material.colour * (material.diffuse * cosine);
}

float phong_highlight(const Shade& shade, const vec3& to_light) {
    const Material& material = *shade.material;
    if (!(material.specular > 0)) return 0;
    return material.specular *
           lobe(dot(mirrored(shade.incoming, shade.normal), to_light), material.shininess);
}

/// Share of a spot light's intensity in `direction` (unit, from the light).
float spot_share(const Light& light, const vec3& direction) {
    const float cosine = dot(light.direction, direction);
    if (cosine >= light.cos_inner) return 1;
    if (cosine <= light.cos_outer) return 0;
    return (cosine - light.cos_outer) / (light.cos_inner - light.cos_outer);
}

}  // namespace

Shade make_shade(const Scene& scene, Rules rules, const Ray& ray, const Hit& hit) {
    Shade shade;
    shade.point = surface_point(scene.geometry, ray, hit);
    shade.time = ray.time;
    shade.incoming = normalised(ray.direction);
    shade.material = &scene.material(hit.primitive);
    shade.rules = rules;
    const bool from_behind = dot(shade.incoming, shade.point.geometric) > 0;
    shade.normal =
        from_behind && rules == Rules::spd_readme ? -shade.point.shading : shade.point.shading;
    return shade;
}

vec3 ambient(const Scene& scene, const Material& material) {
    const auto lights = static_cast<float>(scene.lights.empty() ? 1 : scene.lights.size());
    return material.colour * (material.diffuse * std::sqrt(lights) / (2 * lights));
}

std::optional<Illumination> illumination(const Shade& shade, const Light& light) {
    const bool directional = light.kind == LightKind::directional;
    const vec3 to_light =
        directional ? -light.direction : vec3(dvec3(light.position) - shade.point.position);
    const float distance = length(to_light);
    const vec3 unit = to_light / distance;
    const float cosine = dot(shade.normal, unit);
    if (!(cosine > 0)) return std::nullopt;

    Illumination lit;
    lit.ray = spawned(shade, to_light, directional ? infinity : 1.0f, distance);
    if (!directional) {
        // From where the ray really starts, so that it ends in the light; t_max stays below 1.
        lit.ray.direction = vec3(dvec3(light.position) - dvec3(lit.ray.origin));
        lit.ray.t_max = 1 - 0x1p-24f;
    }
    const float share = light.kind == LightKind::spot ? spot_share(light, -unit) : 1.0f;
    lit.radiance = light.intensity * share *
                   (diffuse(*shade.material, cosine) + vec3(phong_highlight(shade, unit)));
    return lit;
}

std::optional<Illumination> illumination(const Shade& shade, const LightSample& sample,
                                         bool highlight) {
    const float cosine = dot(shade.normal, sample.direction);
    if (!(cosine > 0)) return std::nullopt;
    vec3 reflected = diffuse(*shade.material, cosine);
    // A highlight is no irradiance: it does not fall off with the cosine to the light's direction.
    if (highlight) reflected += vec3(phong_highlight(shade, sample.direction));
    return Illumination{shadow_ray(shade.point, sample, shade.time),
                        sample.incident * std::numbers::inv_pi_v<float> * reflected};
}

Spawned spawned_rays(const Shade& shade, const Blur& blur) {
    const Material& material = *shade.material;
    Spawned rays;
    if (!(material.specular > 0 || material.transmittance > 0)) return rays;
    float mirror_share = material.specular;
    if (material.transmittance > 0) {
        if (const auto direction = refracted(shade)) {
            rays.refraction = sent_on(shade, *direction, blur.refraction, material.transmittance);
        } else {
            rays.totally_reflected = true;
            mirror_share += material.transmittance;
        }
    }
    const vec3 direction = normalised(mirrored(shade.incoming, shade.normal));
    rays.reflection = sent_on(shade, direction, blur.reflection, mirror_share);
    return rays;
}

bool without_falloff(const Light& light) {
    const bool simple = light.kind == LightKind::point || light.kind == LightKind::spot ||
                        light.kind == LightKind::directional;
    return simple && light.falloff == Falloff::none;
}

}  // namespace rayshoot
