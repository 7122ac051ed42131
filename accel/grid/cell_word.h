#pragma once

#include "accel/core/isa.h"

#include <cstdint>

namespace rayshoot::inline RAYSHOOT_ISA {

/// What a cell holds, in one word: a leaf, a grid of its own, or nothing.
class CellWord {
public:
    static constexpr std::uint32_t most_leaves = 1u << 31, most_grids = 1u << 30;
    static constexpr int most_clearance = 63;

    static CellWord leaf(std::uint32_t bits) { return CellWord(bits); }
    static CellWord grid(std::uint32_t number) { return CellWord(other_bit | number); }
    /// `clearance`: cells all round that are empty, too; of macro cells: 1 if the whole macro cell
    /// is.
    static CellWord empty(int clearance = 0) {
        return CellWord(other_bit | empty_bit | static_cast<std::uint32_t>(clearance));
    }

    static CellWord from(std::uint32_t bits) { return CellWord(bits); }

    bool is_leaf() const { return (bits_ & other_bit) == 0; }
    bool is_empty() const { return (bits_ & (other_bit | empty_bit)) == (other_bit | empty_bit); }
    std::uint32_t leaf() const { return bits_; }
    std::uint32_t grid() const { return bits_ & ~other_bit; }
    int clearance() const { return static_cast<int>(bits_ & ~(other_bit | empty_bit)); }
    std::uint32_t bits() const { return bits_; }

private:
    static constexpr std::uint32_t other_bit = 0x80000000, empty_bit = 0x40000000;
    explicit CellWord(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
