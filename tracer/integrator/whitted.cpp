#include "tracer/integrator/whitted.h"

namespace rayshoot {
namespace {

/// The dimension of the numbers that light `light` takes at a hit.
Dimension dimension_of(std::uint32_t light, const Visit& visit) {
    return visit.dimension(Use::light).child(2 + light);
}

}  // namespace

void Whitted::shade(const Visit& visit, Sent& sent) const {
    if (visit.hit.primitive == no_primitive) {
        sent.radiance(visit.path, scene_.background);
        return;
    }
    const Shade shade = make_shade(scene_, settings_.rules, visit.ray, visit.hit);
    sent.radiance(visit.path,
                  ambient(scene_, *shade.material) +
                      lights_.emitted(visit.hit.primitive, shade.point, -shade.incoming));
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

void Whitted::spawn(const Shade& shade, const Visit& visit, Sent& sent) const {
    Blur blur;
    if (shade.material->gloss > 0) {
        const Dimension lobe = visit.dimension(Use::lobe);
        blur = {visit.pair(lobe.child(0)), visit.pair(lobe.child(1))};
    }
    const Spawned spawned = spawned_rays(shade, blur);
    const auto send = [&](const SpawnedRay& ray, Cause cause, std::uint32_t branch) {
        const std::uint32_t place = visit.dimension(Use::lobe).child(branch).place;
        sent.ray(ray.ray, {.shot = visit.path.shot,
                           .place = place,
                           .cause = cause,
                           .throughput = visit.path.throughput * ray.weight});
    };
    if (spawned.reflection) send(*spawned.reflection, Cause::reflection, 0);
    if (spawned.refraction) send(*spawned.refraction, Cause::refraction, 1);
    sent.totally_reflected += spawned.totally_reflected;
}

}  // namespace rayshoot
