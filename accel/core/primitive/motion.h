#pragma once

#include "accel/core/box.h"

#include <array>

/// Rigid motion over the shutter: the one scalar function that moves a ray into a Mover's rest
/// frame.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A point x of the rest frame is at R(time) * (x - pivot) + pivot + translation(time).
/// The translation is a lerp, the rotation a normalised lerp of unit quaternions (x, y, z, w).
struct Motion {
    using Quaternion = std::array<float, 4>;

    vec3 pivot{0};
    std::array<vec3, 2> translation{vec3{0}, vec3{0}};                         ///< at time 0 and 1
    std::array<Quaternion, 2> rotation{Quaternion{0, 0, 0, 1}, {0, 0, 0, 1}};  ///< at time 0 and 1

    bool operator==(const Motion&) const = default;
};

/// The ray as the rest frame sees it at ray.time; t, t_min and t_max keep their meaning.
Ray into_rest_frame(const Motion& motion, const Ray& ray);

/// A point of the rest frame as the world sees it at `time`, clamped to the shutter.
dvec3 move_to_world(const Motion& motion, float time, const dvec3& point);

/// A direction of the rest frame (a normal, say) as the world sees it at `time`.
vec3 rotate_to_world(const Motion& motion, float time, const vec3& direction);

/// Encloses everything inside `rest` over the whole shutter (arcs included), rounded outward.
Box swept(const Motion& motion, const Box& rest);

/// Throws std::invalid_argument for a motion that is not rigid: a quaternion that is not finite and
/// of unit length within 1e-3, or two that are more than 170 degrees apart (the lerp degenerates).
void require_rigid(const Motion& motion);

}  // namespace rayshoot::inline RAYSHOOT_ISA
