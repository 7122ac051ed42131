#pragma once

#include "accel/grid/cell_word.h"
#include "accel/grid/lattice.h"

#include <span>

/// How far round an empty cell there is nothing, so that a ray may leap.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class Skip : std::uint8_t {
    none,
    macro,    ///< whole macro cells, 4 x 4 x 4 of them
    distance  ///< Cohen & Sheffer 1994: the distance to the nearest cell that is not, by chessboard
};

inline constexpr int macro_size = 4;  ///< cells along an axis of a macro cell

/// Writes its clearance into every empty cell of a lattice. In parallel.
void measure_clearance(Skip skip, const Lattice& lattice, std::span<CellWord> cells);

/// The cells that are empty for sure when one is: they contain it.
inline CellRange empty_round(Skip skip, const Lattice& lattice, const Cell& cell, CellWord word) {
    CellRange range;
    const int clearance = word.clearance();
    const Cell last = lattice.last();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = cell[axis];
        const bool macro = skip == Skip::macro;
        const int first_of = macro ? i / macro_size * macro_size : i - clearance;
        const int last_of = macro ? first_of + macro_size - 1 : i + clearance;
        range.first[axis] = first_of > 0 ? first_of : 0;
        range.last[axis] = last_of < last[axis] ? last_of : last[axis];
    }
    return range;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
