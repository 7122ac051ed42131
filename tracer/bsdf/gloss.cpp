#include "tracer/bsdf/gloss.h"

#include "tracer/bsdf/frame.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {

BlurredRay blurred(const vec3& sharp, const SurfacePoint& point, float exponent, Pair pair) {
    if (!(exponent > 0)) return {sharp, 1};
    const vec3 direction = Frame(sharp).to_world(phong_lobe(pair, exponent));
    const auto same_side = [&](const vec3& normal) {
        return dot(normal, sharp) * dot(normal, direction) > 0;
    };
    const bool leaves = same_side(point.geometric) && same_side(point.shading);
    return {direction, leaves ? 1.0f : 0.0f};
}

}  // namespace rayshoot
