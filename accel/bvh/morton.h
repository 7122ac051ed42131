#pragma once

#include "accel/core/box.h"
#include "accel/core/raw_array.h"

#include <cstdint>
#include <span>

namespace rayshoot::inline RAYSHOOT_ISA {

/// A box's place on the Morton curve through the boxes' centres, then its number: all differ.
class MortonKey {
public:
    static constexpr unsigned bits_per_axis = 10, code_bits = 3 * bits_per_axis;

    MortonKey(std::uint32_t code, std::uint32_t number)
        : bits_(std::uint64_t{code} << 32 | number) {}
    std::uint32_t code() const { return static_cast<std::uint32_t>(bits_ >> 32); }
    std::uint32_t number() const { return static_cast<std::uint32_t>(bits_); }
    std::uint64_t bits() const { return bits_; }

private:
    std::uint64_t bits_;
};

/// Sorted (radix sort, in parallel, by the code; equal codes by number).
RawArray<MortonKey> sorted_morton_keys(std::span<const Box> boxes);

}  // namespace rayshoot::inline RAYSHOOT_ISA
