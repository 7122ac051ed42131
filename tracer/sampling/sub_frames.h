#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/sampling/strata.h"

namespace rayshoot {

/// The largest |correlation| of time with x or with y, over all ways to shift the pattern round in
/// x and y. `times` is a permutation of 0..across * down-1, by row.
double largest_correlation(std::span<const std::uint16_t> times, int across, int down);

/// Which sub-frame of the shutter's time each stratum of a pixel is given, from precomputed
/// prototypes (Cook 1986, Fig. 8): permutations that hardly correlate time with place, so that an
/// edge moving through the pixel is sampled as one at rest. Each pixel has one of them, mirrored,
/// turned, shifted round and run backwards at random.
class SubFrames {
public:
    static constexpr int prototypes = 16;

    /// `across`, `down`: strata of the pixel, at most 2^16 together.
    SubFrames(int across, int down, std::uint64_t seed);

    /// Of the stratum, counted by row; a permutation for each key, of 64 random bits. Over the keys
    /// each stratum is given each sub-frame equally often.
    std::uint32_t of(std::uint32_t stratum, std::uint64_t key) const;

    std::span<const std::uint16_t> prototype(int i) const {
        const std::size_t size = times_.size() / prototypes;
        return std::span(times_).subspan(static_cast<std::size_t>(i) * size, size);
    }

private:
    Strata columns_, rows_;
    std::vector<std::uint16_t> times_;  ///< prototypes one after another, each by row
};

}  // namespace rayshoot
