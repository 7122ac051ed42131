#pragma once

#include "accel/bsp/plane.h"
#include "accel/space/membership.h"

#include <glm/common.hpp>

#include <algorithm>

/// Where oblique planes are seen from, and how sharply.
namespace rayshoot::inline RAYSHOOT_ISA {

/// With D the largest distance between an origin and a point of the scene and u = 2^-24: a ray
/// meets an oblique plane where the height of its true point is at most 8 u D (see ../README.md,
/// "General planes"), and the primitive that it is reported to hit there is no farther than the
/// error radius. The margin is larger than both together by another 8 u D, which what builders do
/// in double stays far below.
struct ObliqueFrame {
    vec3 centre{0};     ///< of the scene bounds
    double margin = 0;  ///< what is no farther from a plane is on both of its sides

    ObliqueFrame() = default;
    ObliqueFrame(const Geometry& geometry, const Membership& membership)
        : centre(geometry.bounds().centre()) {
        const dvec3 size = dvec3(geometry.bounds().hi) - dvec3(geometry.bounds().lo);
        const double farthest = double(membership.reach()) + 0.5 * length(size);
        margin = (1 + 0x1p-20) * double(membership.radius()) + 16 * 0x1p-24 * farthest;
    }

    dvec3 local(const vec3& x) const { return dvec3(x) - dvec3(centre); }
    /// The plane across an axis, for who wants to know no more of it than of others.
    ObliquePlane across(int axis, float plane) const {
        ObliquePlane across;
        across.normal[axis] = 1;
        across.offset = static_cast<float>(double(plane) - double(centre[axis]));
        return across;
    }
};

/// Where a ray meets oblique planes: for rays that start within the membership's reach and are
/// ordinary().
struct ObliqueRay {
    vec3 origin;  ///< from the frame's centre
    vec3 direction;

    ObliqueRay(const ObliqueFrame& frame, const vec3& o, const vec3& d)
        : origin(o - frame.centre), direction(d) {}

    /// Products with the direction neither over- nor underflow.
    static bool ordinary(const vec3& d) {
        const vec3 size = glm::abs(d);
        const float largest = std::max({size.x, size.y, size.z});
        return 0x1p-60f <= largest && largest <= 0x1p60f;
    }
    /// How fast the ray rises above the plane.
    float slope(const ObliquePlane& plane) const { return dot(plane.normal, direction); }
    /// Infinite or NaN where that is 0.
    float at(const ObliquePlane& plane, float slope) const {
        const vec3& n = plane.normal;
        const float depth = std::fma(
            -n.z, origin.z, std::fma(-n.y, origin.y, std::fma(-n.x, origin.x, plane.offset)));
        return depth / slope;
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
