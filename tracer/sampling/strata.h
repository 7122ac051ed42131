#pragma once

#include <cassert>
#include <cstdint>

namespace rayshoot {

/// Of the two factors of `count` >= 1 that make the most nearly square strata.
constexpr std::uint32_t smaller_factor(std::uint32_t count) {
    std::uint32_t factor = 1;
    for (std::uint32_t candidate = 2; candidate * candidate <= count; ++candidate)
        if (count % candidate == 0) factor = candidate;
    return factor;
}

/// [0, 1) cut into equal strata, over the multiples of 2^-24 that a float holds. Each of these is
/// in the stratum floor(count * x), exactly; so strata differ in length by at most 2^-24.
class Strata {
public:
    static constexpr std::uint32_t largest_count = 1u << 16;

    explicit constexpr Strata(std::uint32_t count) : count_(count), step_((1ull << 56) / count) {
        assert(count >= 1 && count <= largest_count);
    }
    constexpr std::uint32_t count() const { return count_; }

    /// In stratum i < count, by `bits` uniform in it.
    constexpr float point(std::uint32_t i, std::uint32_t bits) const {
        const std::uint32_t lo = edge(i), length = edge(i + 1) - lo;
        const auto within = static_cast<std::uint32_t>(std::uint64_t{bits} * length >> 32);
        return static_cast<float>(lo + within) * 0x1p-24f;
    }
    /// i / count for any i <= largest_count, without a division.
    constexpr std::uint32_t quotient(std::uint32_t i) const {
        return static_cast<std::uint32_t>((i * (step_ >> 24) + i) >> 32);
    }

private:
    /// The first multiple of 2^-24 in stratum i: ceil(2^24 i / count). The step's error is less
    /// than 2^-16 / count of a multiple after count steps, while a fraction is at least 1 / count.
    constexpr std::uint32_t edge(std::uint32_t i) const {
        return static_cast<std::uint32_t>((i * step_ + 0xffffffffu) >> 32);
    }

    std::uint32_t count_;
    std::uint64_t step_;  ///< 2^56 / count, rounded down
};

}  // namespace rayshoot
