#include "tracer/sampling/pixel_ranks.h"

#include "tracer/random.h"
#include "tracer/sampling/permutation.h"

namespace rayshoot {
namespace {

std::uint16_t rank(int x, int y, std::uint64_t seed) {
    std::uint32_t rank = 0, quad = 1;  // quad: the root is 1, its parts are 4, 5, 6, 7
    for (int level = PixelRanks::levels; level-- > 0;) {
        const auto part = static_cast<std::uint32_t>((y >> level & 1) << 1 | (x >> level & 1));
        rank = 4 * rank + permuted(part, 4, scrambled(seed + quad));
        quad = 4 * quad + part;
    }
    return static_cast<std::uint16_t>(rank);
}

}  // namespace

PixelRanks::PixelRanks(std::uint64_t seed) {
    ranks_.reserve(std::size_t{edge} * edge);
    for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) ranks_.push_back(rank(x, y, seed));
    }
}

}  // namespace rayshoot
