#pragma once

#include <variant>

#include "tracer/light/flat_emitter.h"
#include "tracer/light/point_emitter.h"
#include "tracer/light/sphere_emitter.h"

namespace rayshoot {

/// A light as it is sampled. Each kind has sample, pdf and power.
using Emitter = std::variant<PointEmitter, FlatEmitter, SphereEmitter>;

/// `light` must be valid (require_valid) and outlive it, as `scene` must.
inline Emitter emitter(const Scene& scene, const Light& light) {
    switch (light.kind) {
        case LightKind::point:
        case LightKind::directional:
        case LightKind::spot:
            return PointEmitter(light);
        case LightKind::sphere:
            return SphereEmitter(scene, light);
        case LightKind::rectangle:
        case LightKind::disc:
        case LightKind::triangles:
            break;
    }
    return FlatEmitter(scene, light);
}

}  // namespace rayshoot
