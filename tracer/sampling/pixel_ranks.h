#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rayshoot {

/// Pixels in a hierarchical order: each quad of a quad, and so on down to pixels, is visited as a
/// whole, its four parts in a random order of its own (Ahmed & Wonka 2020: shuffled Z-order). If
/// pixels take consecutive blocks of one well-distributed sequence in that order, then each quad's
/// samples are together well distributed, so errors of neighbours cancel: noise is fine-grained.
class PixelRanks {
public:
    static constexpr int levels = 8;
    static constexpr int edge = 1 << levels;  ///< of a tile, pixels; each tile is ordered alike

    explicit PixelRanks(std::uint64_t seed);

    /// Of pixel (x, y) in its tile, which is (x >> levels, y >> levels). Less than edge^2.
    std::uint32_t operator()(int x, int y) const {
        return ranks_[static_cast<std::size_t>((y & (edge - 1)) << levels | (x & (edge - 1)))];
    }

private:
    std::vector<std::uint16_t> ranks_;  ///< by row
};

}  // namespace rayshoot
