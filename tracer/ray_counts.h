#pragma once

#include "accel/core/ray.h"

#include <array>
#include <cstdint>
#include <string_view>

/// How many rays of each kind an image took, and how many of them hit something.
namespace rayshoot {

/// reflection, refraction: a bounce to the side of the surface that the ray came from, or through
/// it.
enum class Cause : std::uint8_t { camera, shadow, reflection, refraction };
inline constexpr std::array<std::string_view, 4> cause_names{"camera", "shadow", "reflection",
                                                             "refraction"};

struct RayCount {
    std::uint64_t rays = 0, hits = 0;
    bool operator==(const RayCount&) const = default;
};

/// Rays and hits by what caused the ray; secondary rays are the reflected and the refracted ones.
struct RayCounts {
    std::array<RayCount, 4> by_cause{};
    /// Refractions that were not traced. Published tables count them as rays without a hit.
    std::uint64_t totally_reflected = 0;

    RayCount& operator[](Cause cause) { return by_cause[static_cast<std::size_t>(cause)]; }
    const RayCount& operator[](Cause cause) const {
        return by_cause[static_cast<std::size_t>(cause)];
    }
    RayCount of(RayKind kind) const;
    RayCounts& operator+=(const RayCounts& other);
    bool operator==(const RayCounts&) const = default;
};

}  // namespace rayshoot
