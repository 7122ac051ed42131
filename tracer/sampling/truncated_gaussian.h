#pragma once

#include <cstdint>
#include <vector>

namespace rayshoot {

/// From uniform numbers to those of a Gaussian round the middle of [0, 1) whose ends are two
/// standard deviations away, and that is cut off there. Numbers are 32-bit fractions. The inverse
/// of the distribution is tabulated, in arithmetic that rounds alike everywhere, and interpolated.
class TruncatedGaussian {
public:
    static constexpr double deviation = 0.25;

    TruncatedGaussian();

    std::uint32_t operator()(std::uint32_t uniform) const {
        const std::size_t interval = uniform >> interval_bits;
        const std::uint64_t within = uniform & ((1u << interval_bits) - 1);
        const std::uint32_t lo = quantiles_[interval], hi = quantiles_[interval + 1];
        return lo + static_cast<std::uint32_t>((hi - lo) * within >> interval_bits);
    }

private:
    /// 1024 intervals: each is met as often as it should, and within it uniformly, which at the
    /// ends is 2 % off the density.
    static constexpr int interval_bits = 22;
    std::vector<std::uint32_t> quantiles_;
};

}  // namespace rayshoot
