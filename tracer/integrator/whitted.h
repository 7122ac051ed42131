#pragma once

#include "tracer/integrator/lamp_parts.h"
#include "tracer/integrator/transport.h"
#include "tracer/light/lights.h"

namespace rayshoot {

/// Whitted 1980 under the testing rules of the Standard Procedural Databases, distributed as Cook,
/// Porter & Carpenter 1984 do: a shadow ray aims at a random point of its lamp, a reflection and a
/// refraction go in a random direction round the ideal one where the material blurs them. A scene
/// of point lights and perfect mirrors has no such choice, and is traced as Whitted did. Of
/// materials it reads what NFF has, gloss and emission.
class Whitted final : public Integrator {
public:
    Whitted(const Scene& scene, const TransportSettings& settings);

    void shade(const Visit& visit, Sent& sent) const override;

private:
    void light(const Shade& shade, const Visit& visit, Sent& sent) const;
    void light_by_lamp(std::uint32_t light, const Shade& shade, const Visit& visit,
                       Sent& sent) const;
    void spawn(const Shade& shade, const Visit& visit, Sent& sent) const;
    void send(Cause cause, const vec3& sharp, float share, const Shade& shade, const Visit& visit,
              Sent& sent) const;

    const Scene& scene_;
    Lights lights_;
    Ambient ambient_;
    bool emits_;  ///< whether any surface does
    TransportSettings settings_;
};

}  // namespace rayshoot
