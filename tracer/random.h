#pragma once

#include <cstdint>

/// Counter-based random numbers: a pure function of (seed, pixel, sample, dimension), so that
/// images depend on neither thread count nor tile order. Integer arithmetic only, alike on every
/// machine.
namespace rayshoot {

/// The 64-bit finaliser of Stafford's variant 13, as used by SplitMix64 (Steele, Lea & Flood 2014).
constexpr std::uint64_t scrambled(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The random numbers of one sample of one pixel.
class RandomSequence {
public:
    constexpr RandomSequence(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
        : key_(scrambled(scrambled(seed + golden) ^ (std::uint64_t{pixel} << 32 | sample))) {}

    constexpr std::uint32_t bits(std::uint32_t dimension) const {
        return static_cast<std::uint32_t>(scrambled(key_ + (dimension + 1) * golden) >> 32);
    }
    /// In [0, 1): a multiple of 2^-24.
    constexpr float number(std::uint32_t dimension) const {
        return static_cast<float>(bits(dimension) >> 8) * 0x1p-24f;
    }

private:
    static constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;  ///< 2^64 / golden ratio, odd
    std::uint64_t key_;
};

}  // namespace rayshoot
