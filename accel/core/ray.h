#pragma once

#include "accel/core/vec.h"

#include <cstdint>
#include <limits>
#include <span>

/// What is asked (rays, in batches) and what is answered (hits).
namespace rayshoot::inline RAYSHOOT_ISA {

inline constexpr float infinity = std::numeric_limits<float>::infinity();

/// A hit counts iff t_min < t < t_max; t is in units of |direction|, which may have any length but
/// 0.
struct Ray {
    vec3 origin{0};
    float t_min = 0;  ///< may be -infinity
    vec3 direction{0, 0, 1};
    float t_max = infinity;  ///< +infinity is valid
    float time = 0;          ///< shutter time in [0, 1]; clamped where it is not
};
static_assert(sizeof(Ray) == 36);

inline constexpr std::uint32_t no_primitive = 0xffffffff;

struct Hit {
    float t = infinity;  ///< +infinity on a miss
    std::uint32_t primitive = no_primitive;
    float u = 0, v = 0;  ///< barycentrics of a triangle (weights of its 2nd and 3rd vertex), else 0

    bool operator==(const Hit&) const = default;
};
static_assert(sizeof(Hit) == 16);

/// The two questions. One text answers both through this template parameter, never through a bool.
enum class Query : std::uint8_t { closest, occluded };

enum class RayKind : std::uint8_t { camera, shadow, secondary };
inline constexpr int ray_kinds = 3;

/// Where a ray comes from: a promise of the caller that partial structures build on.
/// camera: the raster cell that the ray goes through; shadow: the light's index; secondary: unused.
struct Source {
    std::uint32_t bits = 0;

    static Source cell(std::int16_t x, std::int16_t y) {
        return {static_cast<std::uint16_t>(x) |
                static_cast<std::uint32_t>(static_cast<std::uint16_t>(y)) << 16};
    }
    static Source light(std::uint32_t index) { return {index}; }

    std::int16_t cell_x() const { return static_cast<std::int16_t>(bits & 0xffff); }
    std::int16_t cell_y() const { return static_cast<std::int16_t>(bits >> 16); }
};

inline constexpr std::size_t max_batch = 4096;      ///< rays
inline constexpr std::size_t default_batch = 1024;  ///< rays; 256 to 4096 measured alike

struct RayBatch {
    RayKind kind = RayKind::secondary;
    std::uint8_t depth = 1;            ///< level in the ray tree; 1 is the camera's
    std::span<const Ray> rays{};       ///< at most max_batch
    std::span<const Source> source{};  ///< empty, or one per ray
};

/// NaN anywhere, an infinite origin or direction, a zero direction or t_min >= t_max: no hit, no
/// test.
inline bool answerable(const Ray& ray) {
    const vec3 &o = ray.origin, &d = ray.direction;
    // Without a branch: this is asked of every ray. Infinities and NaN times 0 are NaN.
    const bool numbers = (o.x * 0 + o.y * 0) + (o.z * 0 + d.x * 0) + (d.y * 0 + d.z * 0) == 0;
    const bool somewhere = (d.x != 0) | (d.y != 0) | (d.z != 0);
    return numbers & somewhere & (ray.t_min < ray.t_max) & (ray.time == ray.time);
}

/// The time that is answered for: clamped to [0, 1], here and nowhere else.
inline float shutter_time(float time) { return time < 0 ? 0.0f : time > 1 ? 1.0f : time; }

}  // namespace rayshoot::inline RAYSHOOT_ISA
