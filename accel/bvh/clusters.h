#pragma once

#include "accel/bvh/morton.h"

#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {

/// Boxes in the order of their Morton keys, and in it the largest nodes of the radix tree over the
/// keys that are small enough: the clusters.
class MortonClusters {
public:
    /// At least one box; clusters of at most `most`.
    MortonClusters(std::span<const Box> boxes, std::uint32_t most);

    std::size_t size() const { return first_.size() - 1; }
    std::uint32_t first(std::size_t cluster) const { return first_[cluster]; }
    std::span<const MortonKey> operator[](std::size_t cluster) const {
        return std::span(keys_).subspan(first_[cluster], first_[cluster + 1] - first_[cluster]);
    }

private:
    RawArray<MortonKey> keys_;
    std::vector<std::uint32_t> first_;  ///< place of each cluster's first key, and the end
};

/// How many of at least two keys come before the place where the highest bit that differs becomes 1
/// (Lauterbach et al. 2009).
std::uint32_t radix_split(std::span<const MortonKey> keys);

/// The same among the places that cost no more leaves of up to `largest` boxes than need be.
std::uint32_t split_into_full_leaves(std::span<const MortonKey> keys, std::uint32_t largest);

}  // namespace rayshoot::inline RAYSHOOT_ISA
