#pragma once

#include "accel/core/vec.h"

/// Planes that need not lie across an axis.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The points x, as seen from the centre of the scene bounds, with dot(normal, x) = offset. From
/// there numbers are no larger than the scene, wherever it lies.
struct ObliquePlane {
    vec3 normal{0};  ///< of length 1, but for rounding
    float offset = 0;

    double height(const dvec3& x) const { return dot(dvec3(normal), x) - double(offset); }
    bool operator==(const ObliquePlane&) const = default;
};
static_assert(sizeof(ObliquePlane) == 16);

}  // namespace rayshoot::inline RAYSHOOT_ISA
