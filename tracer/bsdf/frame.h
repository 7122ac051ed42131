#pragma once

#include <cmath>

#include "accel/core/vec.h"

namespace rayshoot {

/// An orthonormal frame round a normal, right-handed (Duff et al. 2017, without a branch).
template <std::floating_point F>
struct FrameOf {
    vec<F> tangent{1, 0, 0}, bitangent{0, 1, 0}, normal{0, 0, 1};

    FrameOf() = default;
    explicit FrameOf(const vec<F>& unit) : normal(unit) {
        const F sign = std::copysign(F(1), unit.z);
        const F a = -1 / (sign + unit.z), b = unit.x * unit.y * a;
        tangent = {1 + sign * unit.x * unit.x * a, sign * b, -sign * unit.x};
        bitangent = {b, sign + unit.y * unit.y * a, -unit.y};
    }

    vec<F> to_local(const vec<F>& world) const {
        return {dot(world, tangent), dot(world, bitangent), dot(world, normal)};
    }
    vec<F> to_world(const vec<F>& local) const {
        return local.x * tangent + local.y * bitangent + local.z * normal;
    }
};
using Frame = FrameOf<float>;

}  // namespace rayshoot
