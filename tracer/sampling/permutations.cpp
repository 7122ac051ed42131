#include "tracer/sampling/permutations.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "tracer/random.h"
#include "tracer/sampling/permutation.h"

namespace rayshoot {
namespace {

constexpr std::uint32_t most_rows = 256;
constexpr std::uint32_t most_entries = 1u << 15;  // 64 KiB, to stay in the second-level cache

}  // namespace

Permutations::Permutations(std::uint32_t length, std::uint64_t seed)
    : length_(length), rows_(std::bit_floor(std::clamp(most_entries / length, 1u, most_rows))) {
    if (length > largest_table) return;
    table_.reserve(std::size_t{rows_} * length);
    for (std::uint32_t row = 0; row < rows_; ++row) {
        const std::uint64_t key = scrambled(seed + row);
        for (std::uint32_t i = 0; i < length; ++i) {
            table_.push_back(static_cast<std::uint16_t>(permuted(i, length, key)));
        }
    }
}

std::uint32_t Permutations::operator()(std::uint32_t index, std::uint64_t key) const {
    assert(index < length_);
    if (table_.empty()) return permuted(index, length_, key);
    const auto before = static_cast<std::uint32_t>((key >> 8 & 0xffffff) * length_ >> 24);
    const auto after = static_cast<std::uint32_t>((key >> 32) * length_ >> 32);
    const auto row = static_cast<std::uint32_t>(key & (rows_ - 1));
    const std::uint32_t sent = table_[row * length_ + turned(index, before, length_)];
    return turned(sent, after, length_);
}

}  // namespace rayshoot
