#pragma once

#include <concepts>
#include <numbers>
#include <optional>

#include "accel/core/vec.h"
#include "tracer/sampling/pair.h"

/// What every surface model can do, in the local frame of a hit: z is the shading normal on the
/// side of `out`, so out.z > 0; in.z < 0 is beyond the surface. All directions are unit vectors
/// that point away from the surface.
namespace rayshoot {

inline constexpr float pi = std::numbers::pi_v<float>;

struct LobeSample {
    vec3 in;
    vec3 weight;    ///< f |cos in| / pdf; of a delta: what it passes on / its probability
    float pdf = 0;  ///< per solid angle; of a delta 0
    bool delta = false;
};

/// evaluate: f |cos in| without deltas; pdf: of sample() without deltas; sample: empty if absorbed.
template <class L>
concept Lobe = requires(const L& lobe, const vec3& out, const vec3& in, float choice, Pair pair) {
    { lobe.evaluate(out, in) } -> std::same_as<vec3>;
    { lobe.pdf(out, in) } -> std::same_as<float>;
    { lobe.sample(out, choice, pair) } -> std::same_as<std::optional<LobeSample>>;
    { lobe.only_deltas() } -> std::same_as<bool>;
};

inline vec3 mirrored(const vec3& out) { return {-out.x, -out.y, out.z}; }

inline float mean(const vec3& colour) { return (colour.x + colour.y + colour.z) / 3; }
inline float largest(const vec3& colour) {
    return colour.x > colour.y ? (colour.x > colour.z ? colour.x : colour.z)
                               : (colour.y > colour.z ? colour.y : colour.z);
}

/// By what a surface must be scaled so that it does not reflect more than comes in.
inline float energy_limit(float albedo) { return albedo > 1 ? 1 / albedo : 1; }

}  // namespace rayshoot
