#include "tracer/integrator/whitted.h"

#include <algorithm>

#include "tracer/bsdf/gloss.h"

namespace rayshoot {
namespace {

/// The dimension of the numbers that light `light` takes at a hit.
Dimension dimension_of(std::uint32_t light, const Visit& visit) {
    return visit.dimension(Use::light).child(2 + light);
}

bool any_emits(const Scene& scene) {
    return std::ranges::any_of(scene.lights,
                               [](const Light& l) { return !l.primitives.empty(); }) ||
           std::ranges::any_of(scene.materials,
                               [](const Material& m) { return m.emission != vec3(0); });
}

}  // namespace

Whitted::Whitted(const Scene& scene, const TransportSettings& settings)
    : scene_(scene),
      lights_(scene),
      ambient_(scene),
      emits_(any_emits(scene)),
      settings_(settings) {}

void Whitted::shade(const Visit& visit, Sent& sent) const {
    if (visit.hit.primitive == no_primitive) {
        sent.radiance(visit.path, scene_.background);
        return;
    }
    const Shade shade = make_shade(scene_, settings_.rules, visit.ray, visit.hit);
    vec3 radiance = ambient_.reflected(*shade.material);
    if (emits_) radiance += lights_.emitted(visit.hit.primitive, shade.point, -shade.incoming);
    sent.radiance(visit.path, radiance);
    light(shade, visit, sent);
    if (visit.depth < levels(settings_)) spawn(shade, visit, sent);
}

void Whitted::light(const Shade& shade, const Visit& visit, Sent& sent) const {
    for (std::uint32_t light = 0; light < scene_.lights.size(); ++light) {
        if (!without_falloff(scene_.lights[light])) {
            light_by_lamp(light, shade, visit, sent);
        } else if (const auto lit = illumination(shade, scene_.lights[light])) {
            sent.shadow(light, lit->ray, visit.path, lit->radiance);
        }
    }
}

/// One shadow ray, whose place on the lamp is stratified over the pixel's samples, or several, each
/// in a part of the lamp of its own.
void Whitted::light_by_lamp(std::uint32_t light, const Shade& shade, const Visit& visit,
                            Sent& sent) const {
    const Light& lamp = scene_.lights[light];
    const LampParts parts = settings_.light_samples > 0 ? LampParts::of(settings_.light_samples)
                                                        : LampParts{lamp.strata_u, lamp.strata_v};
    const float share = 1.0f / static_cast<float>(parts.count());
    const bool highlight = lamp.primitives.empty();
    for (int part = 0; part < parts.count(); ++part) {
        const Dimension numbers = dimension_of(light, visit).child(2 + static_cast<unsigned>(part));
        const auto sample = lights_.sample(light, shade.point.position, shade.time,
                                           parts.within(part, visit.pair(numbers)));
        if (!sample) continue;
        if (const auto lit = illumination(shade, *sample, highlight))
            sent.shadow(light, lit->ray, visit.path, lit->radiance * share);
    }
}

/// Wherever Ks > 0 or T > 0 a ray is mirrored, where T > 0 another one is refracted, unless it is
/// totally reflected; then its share adds to the other's.
void Whitted::spawn(const Shade& shade, const Visit& visit, Sent& sent) const {
    const Material& material = *shade.material;
    if (!(material.specular > 0 || material.transmittance > 0)) return;
    float mirror_share = material.specular;
    if (material.transmittance > 0) {
        if (const auto direction = refracted(shade)) {
            send(Cause::refraction, *direction, material.transmittance, shade, visit, sent);
        } else {
            ++sent.totally_reflected;
            mirror_share += material.transmittance;
        }
    }
    const vec3 direction = normalised(mirrored(shade.incoming, shade.normal));
    send(Cause::reflection, direction, mirror_share, shade, visit, sent);
}

/// In the direction `sharp` of a perfect mirror or glass, or round it where the material blurs.
/// Blurred rays that would leave to the wrong side of the surface are left out.
void Whitted::send(Cause cause, const vec3& sharp, float share, const Shade& shade,
                   const Visit& visit, Sent& sent) const {
    const Dimension branch = visit.dimension(Use::lobe).child(cause == Cause::refraction);
    BlurredRay blur{sharp, 1};
    if (shade.material->gloss > 0)
        blur = blurred(sharp, shade.point, shade.material->gloss, visit.pair(branch));
    if (!(blur.weight > 0)) return;
    sent.ray(spawned(shade, blur.direction),
             {.shot = visit.path.shot,
              .place = branch.place,
              .cause = cause,
              .throughput = visit.path.throughput * (share * blur.weight)});
}

}  // namespace rayshoot
