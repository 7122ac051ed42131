#include "accel/bvh/clusters.h"

#include <algorithm>
#include <bit>

namespace rayshoot::inline RAYSHOOT_ISA {

MortonClusters::MortonClusters(std::span<const Box> boxes, std::uint32_t most)
    : keys_(sorted_morton_keys(boxes)) {
    struct Range {
        std::uint32_t first, last;
    };
    std::vector<Range> pending{{0, static_cast<std::uint32_t>(boxes.size())}};
    while (!pending.empty()) {
        const auto [first, last] = pending.back();
        pending.pop_back();
        if (last - first <= most) {
            first_.push_back(first);
            continue;
        }
        const std::uint32_t middle =
            first + radix_split(std::span(keys_).subspan(first, last - first));
        pending.push_back({middle, last});
        pending.push_back({first, middle});
    }
    first_.push_back(static_cast<std::uint32_t>(boxes.size()));
}

std::uint32_t radix_split(std::span<const MortonKey> keys) {
    const std::uint64_t low = keys.front().bits(), high = keys.back().bits();
    const auto equal_above = std::bit_width(low ^ high) - 1;
    const std::uint64_t from = high >> equal_above << equal_above;
    const auto middle = std::partition_point(
        keys.begin(), keys.end(), [from](const MortonKey& key) { return key.bits() < from; });
    return static_cast<std::uint32_t>(middle - keys.begin());
}

std::uint32_t split_into_full_leaves(std::span<const MortonKey> keys, std::uint32_t largest) {
    // Leaves before place i have (-i mod largest) places free; all together need not have more.
    const auto size = static_cast<std::uint32_t>(keys.size());
    const std::uint32_t free = (size + largest - 1) / largest * largest - size;
    std::uint32_t best = largest;
    std::uint64_t difference = 0;
    for (std::uint32_t end = largest; end < size + free; end += largest) {
        for (std::uint32_t i = end - free; i <= end && i < size; ++i) {
            const std::uint64_t here = keys[i - 1].bits() ^ keys[i].bits();
            if (here <= difference) continue;
            best = i;
            difference = here;
        }
    }
    return best;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
