#pragma once

#include "data/generators/transform.h"

#include <cstdint>

/// Counter-based random numbers: each is a hash of (seed, item, draw), so that an item does not
/// depend on how many came before it. Integers, + - * / and sqrt only: the same on every machine.
namespace rayshoot::procedural {

/// The output function of SplitMix64 (Steele, Lea & Flood 2014).
inline std::uint64_t hash(std::uint64_t x) {
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
    x = (x ^ x >> 27) * 0x94d049bb133111eb;
    return x ^ x >> 31;
}

class Random {
public:
    Random(std::uint64_t seed, std::uint64_t item) : state_(hash(hash(seed + golden) + item)) {}

    /// In [0, 1), a multiple of 2^-53.
    double uniform() {
        state_ += golden;
        return static_cast<double>(hash(state_) >> 11) * 0x1p-53;
    }

    /// In the unit cube.
    dvec3 place() {
        const double x = uniform(), y = uniform(), z = uniform();
        return {x, y, z};
    }

    /// Uniform on the unit sphere: a place in the ball, by rejection, thrown outward.
    dvec3 direction() {
        constexpr double too_short = 1e-4;  // squared; keeps the division sound
        for (;;) {
            const dvec3 p = 2.0 * place() - 1.0;
            const double square = glm::dot(p, p);
            if (square <= 1 && square > too_short) return unit(p);
        }
    }

    /// A unit vector across another, every turn round it alike.
    dvec3 across(const dvec3& axis) {
        constexpr double too_parallel = 1e-4;  // squared sine
        for (;;) {
            const dvec3 p = glm::cross(axis, direction());
            if (glm::dot(p, p) > too_parallel) return unit(p);
        }
    }

private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 / golden ratio, odd
    std::uint64_t state_;
};

}  // namespace rayshoot::procedural
