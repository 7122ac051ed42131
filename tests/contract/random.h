#pragma once

#include "accel/core/box.h"

#include <cstdint>
#include <random>

/// Random numbers that are the same on every machine: the standard fixes what mt19937_64 gives, but
/// not what its distributions make of it.
namespace rayshoot::contract {

class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// In [0, 1), a multiple of 2^-24.
    float unit() { return static_cast<float>(engine_() >> 40) * 0x1p-24f; }
    float between(float lo, float hi) { return std::fma(unit(), hi - lo, lo); }
    std::uint32_t below(std::uint32_t bound) {
        return static_cast<std::uint32_t>((engine_() >> 32) * bound >> 32);
    }
    bool coin() { return (engine_() >> 63) != 0; }

    vec3 inside(const Box& box) {
        vec3 p;
        for (int axis = 0; axis < 3; ++axis) p[axis] = between(box.lo[axis], box.hi[axis]);
        return p;
    }
    /// Uniform on the unit sphere: rejected from the cube, so no transcendental function.
    vec3 direction() {
        for (;;) {
            const vec3 p = inside(Box{vec3(-1), vec3(1)});
            const float square = dot(p, p);
            if (square > 0x1p-6f && square <= 1) return p / std::sqrt(square);
        }
    }
    /// A power of two with an exponent in [lowest, highest].
    float power_of_two(int lowest, int highest) {
        const auto range = static_cast<std::uint32_t>(highest - lowest + 1);
        return std::ldexp(1.0f, lowest + static_cast<int>(below(range)));
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace rayshoot::contract
