#pragma once

#include "accel/core/vec.h"
#include "tracer/sampling/pair.h"
#include "tracer/surface.h"

/// Blurred reflection and refraction of the Whitted integrator: Cook, Porter & Carpenter 1984
/// distribute the secondary rays round the direction that a perfect mirror or glass would send
/// them.
namespace rayshoot {

struct BlurredRay {
    vec3 direction;    ///< unit
    float weight = 1;  ///< 0: clipped, on the wrong side of the surface; trace nothing
};

/// A direction of the Phong lobe (exponent + 1) / (2 pi) cos^exponent round the unit vector `sharp`
/// (the mirrored or the refracted direction). `exponent` <= 0: sharp itself. The weight is 0 where
/// the direction is not on the same side of both normals of `point` as `sharp` is.
BlurredRay blurred(const vec3& sharp, const SurfacePoint& point, float exponent, Pair pair);

}  // namespace rayshoot
