#include "tracer/bsdf/ggx.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

#include "tracer/bsdf/lobe.h"
#include "tracer/sampling/warp.h"

namespace rayshoot {

float Ggx::density(const vec3& normal) const {
    const float alpha2 = alpha * alpha;
    const float sine2 = normal.x * normal.x + normal.y * normal.y;
    const float spread = alpha2 * normal.z * normal.z + sine2;
    return alpha2 / (pi * spread * spread);
}

float Ggx::lambda(const vec3& direction) const {
    const float sine2 = direction.x * direction.x + direction.y * direction.y;
    const float slope2 = alpha * alpha * sine2 / (direction.z * direction.z);
    // (sqrt(1 + s) - 1) / 2 without cancellation; s may overflow to infinity at the horizon.
    return slope2 < 1 ? slope2 / (2 * (1 + std::sqrt(1 + slope2)))
                      : (std::sqrt(1 + slope2) - 1) / 2;
}

/// Heitz 2018: stretched so that facets lie on the hemisphere, a point of its projection is chosen,
/// a disc whose one half is seen foreshortened; then squeezed back.
vec3 Ggx::visible_normal(const vec3& out, Pair pair) const {
    const vec3 view = normalised(vec3(alpha * out.x, alpha * out.y, out.z));
    const float across2 = view.x * view.x + view.y * view.y;
    const vec3 right = across2 > 0 ? vec3(-view.y, view.x, 0) / std::sqrt(across2) : vec3(1, 0, 0);
    const vec3 up = cross(view, right);
    const glm::vec2 disc = concentric_disc(pair);
    const float chord = std::sqrt(std::max(0.0f, 1 - disc.x * disc.x));
    const float share = (1 + view.z) / 2;
    const float height = (1 - share) * chord + share * disc.y;
    const float depth = std::sqrt(std::max(0.0f, 1 - disc.x * disc.x - height * height));
    const vec3 facet = disc.x * right + height * up + depth * view;
    return normalised(vec3(alpha * facet.x, alpha * facet.y, std::max(0.0f, facet.z)));
}

}  // namespace rayshoot
