#pragma once

#include "accel/core/leaves.h"
#include "accel/grid/cell_word.h"
#include "accel/grid/clearance.h"
#include "accel/grid/resolution.h"
#include "accel/space/membership.h"

/// A grid, and grids in its cells: what the builder makes. It knows nothing of how leaves are
/// tested.
namespace rayshoot::inline RAYSHOOT_ISA {

struct GridSettings {
    Resolution resolution;
    double density = 4;      ///< cells per primitive
    double top_density = 4;  ///< the same for the outermost grid
    int levels = 1;          ///< of grids in grids
    std::uint32_t leaf = 8;  ///< a cell with more primitives gets a grid, if levels are left
    double bound = 64;       ///< references per primitive, by boxes, that are not exceeded
    Skip skip = Skip::none;
    float lowered = 0;  ///< by which all planes of the outermost grid lie lower than its box says
};

/// One of the grids: its cells stand together.
struct SubGrid {
    Lattice lattice;
    std::uint32_t first_cell = 0;
};

struct GridTree {
    std::vector<SubGrid> grids;          ///< 0: the outermost one; none for no primitives
    PagedVector<CellWord> cells;         ///< a leaf's word is its number
    std::vector<LeafRange> leaves;       ///< in `members`
    std::vector<std::uint32_t> members;  ///< primitive numbers, those of a leaf ascending
    std::uint64_t empty_cells = 0;
    int depth = 0;       ///< of the deepest cell; that of the outermost grid's is 1
    std::string remark;  ///< whether it stopped at the bound
};

/// In parallel, and the same for any number of threads.
GridTree build_grid_tree(const BuildInput& input, const Membership& membership,
                         const GridSettings& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
