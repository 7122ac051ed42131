#pragma once

#include <cstddef>
#include <cstdint>

/// Numbers that look random and are the same on every machine and with every standard library.
namespace rayshoot {

/// Steele, Lea & Flood 2014: SplitMix64.
class Sequence {
public:
    explicit Sequence(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    /// In [0, count); count > 0. The bias of the modulus is below count / 2^64.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

    /// In [0, 1), a multiple of 2^-24, so exact in a float.
    float unit() { return static_cast<float>(next() >> 40) * 0x1p-24f; }

private:
    std::uint64_t state_;
};

}  // namespace rayshoot
