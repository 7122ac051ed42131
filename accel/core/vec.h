#pragma once

#include "accel/core/isa.h"

#include <glm/vec3.hpp>

#include <cmath>
#include <concepts>

/// Vectors are GLM's; the product-sums that decide a hit are written here, each as an explicit fma,
/// so that every compiler, every vector width and every structure rounds alike.
namespace rayshoot::inline RAYSHOOT_ISA {

using vec3 = glm::vec3;
using dvec3 = glm::dvec3;

template <std::floating_point F>
using vec = glm::vec<3, F>;

// These two are shorter than a call, which g++ 12 makes of them in large functions.
template <std::floating_point F>
[[gnu::always_inline]] inline F dot(const vec<F>& a, const vec<F>& b) {
    return std::fma(a.z, b.z, std::fma(a.y, b.y, a.x * b.x));
}

/// origin + t * direction, rounded once a component.
template <std::floating_point F>
[[gnu::always_inline]] inline vec<F> along(const vec<F>& origin, F t, const vec<F>& direction) {
    return {std::fma(t, direction.x, origin.x), std::fma(t, direction.y, origin.y),
            std::fma(t, direction.z, origin.z)};
}

template <std::floating_point F>
inline vec<F> cross(const vec<F>& a, const vec<F>& b) {
    return {std::fma(a.y, b.z, -(a.z * b.y)), std::fma(a.z, b.x, -(a.x * b.z)),
            std::fma(a.x, b.y, -(a.y * b.x))};
}

template <std::floating_point F>
inline F length(const vec<F>& a) {
    return std::sqrt(dot(a, a));
}

template <std::floating_point F>
inline vec<F> normalised(const vec<F>& a) {
    return a / length(a);
}

/// |x| + |y| + |z|: a length without a square, so it neither over- nor underflows early.
template <std::floating_point F>
inline F taxicab(const vec<F>& a) {
    return std::abs(a.x) + std::abs(a.y) + std::abs(a.z);
}

template <std::floating_point F>
inline bool finite(const vec<F>& a) {
    return 0 * a.x + 0 * a.y + 0 * a.z == 0;  // infinities and NaN give NaN
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
