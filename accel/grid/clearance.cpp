#include "accel/grid/clearance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Calls work(z) for every layer of cells: at once where they are many.
template <class Work>
void for_each_layer(const Lattice& lattice, const Work& work) {
    constexpr std::size_t few = 4096;
    const int layers = lattice.cells()[2];
    if (lattice.size() >= few) return tbb::parallel_for(0, layers, work);
    for (int z = 0; z < layers; ++z) work(z);
}

/// A bit for each cell of a lattice, in rows along x of whole words.
class Bitmap {
public:
    using Word = std::uint64_t;
    static constexpr std::size_t width = 64;

    explicit Bitmap(const Lattice& lattice)
        : rows_(static_cast<std::size_t>(lattice.cells()[1])),
          layers_(static_cast<std::size_t>(lattice.cells()[2])),
          words_((static_cast<std::size_t>(lattice.cells()[0]) + width - 1) / width),
          bits_(rows_ * layers_ * words_) {}

    std::size_t words() const { return words_; }
    Word* row(int y, int z) {
        return &bits_[(static_cast<std::size_t>(z) * rows_ + static_cast<std::size_t>(y)) * words_];
    }
    const Word* row(int y, int z) const { return const_cast<Bitmap*>(this)->row(y, z); }

private:
    std::size_t rows_, layers_, words_;
    std::vector<Word> bits_;
};

Bitmap occupied(const Lattice& lattice, std::span<const CellWord> cells) {
    Bitmap map(lattice);
    for_each_layer(lattice, [&](int z) {
        for (int y = 0; y < lattice.cells()[1]; ++y) {
            const CellWord* const row = &cells[lattice.number({0, y, z})];
            for (int x = 0; x < lattice.cells()[0]; ++x)
                if (!row[x].is_empty()) {
                    const auto at = static_cast<std::size_t>(x);
                    map.row(y, z)[at / Bitmap::width] |= Bitmap::Word{1} << at % Bitmap::width;
                }
        }
    });
    return map;
}

/// Sets what is next to something set along x, then y, then z: the 26 neighbours of each cell.
void spread_along_rows(const Lattice& lattice, const Bitmap& from, Bitmap& to) {
    for_each_layer(lattice, [&](int z) {
        for (int y = 0; y < lattice.cells()[1]; ++y) {
            const Bitmap::Word* const row = from.row(y, z);
            for (std::size_t i = 0; i < from.words(); ++i) {
                Bitmap::Word word = row[i] | row[i] << 1 | row[i] >> 1;
                if (i > 0) word |= row[i - 1] >> (Bitmap::width - 1);
                if (i + 1 < from.words()) word |= row[i + 1] << (Bitmap::width - 1);
                to.row(y, z)[i] = word;
            }
        }
    });
}

/// `y`, `z`: 1 along the axis, 0 along the other.
void spread_across(const Lattice& lattice, int along_y, int along_z, const Bitmap& from,
                   Bitmap& to) {
    for_each_layer(lattice, [&](int z) {
        for (int y = 0; y < lattice.cells()[1]; ++y)
            for (std::size_t i = 0; i < from.words(); ++i) {
                Bitmap::Word word = from.row(y, z)[i];
                const int before_y = y - along_y, before_z = z - along_z;
                const int after_y = y + along_y, after_z = z + along_z;
                if (before_y >= 0 && before_z >= 0) word |= from.row(before_y, before_z)[i];
                if (after_y < lattice.cells()[1] && after_z < lattice.cells()[2])
                    word |= from.row(after_y, after_z)[i];
                to.row(y, z)[i] = word;
            }
    });
}

/// Writes a clearance into the cells that are in one map and not in the other; whether there are
/// any.
bool write(int clearance, const Bitmap& in, const Bitmap& not_in, const Lattice& lattice,
           std::span<CellWord> cells) {
    std::atomic<bool> any = false;
    for_each_layer(lattice, [&](int z) {
        for (int y = 0; y < lattice.cells()[1]; ++y) {
            CellWord* const row = &cells[lattice.number({0, y, z})];
            for (std::size_t i = 0; i < in.words(); ++i) {
                Bitmap::Word fresh = in.row(y, z)[i] & ~not_in.row(y, z)[i];
                for (; fresh != 0; fresh &= fresh - 1) {
                    const std::size_t x =
                        i * Bitmap::width + static_cast<std::size_t>(std::countr_zero(fresh));
                    if (x >= static_cast<std::size_t>(lattice.cells()[0])) break;
                    row[x] = CellWord::empty(clearance);
                    any.store(true, std::memory_order_relaxed);
                }
            }
        }
    });
    return any;
}

/// Cells that the nth spreading reaches first have n - 1 empty ones all round. Those that none
/// reaches have as many as can be told.
void measure_distance(const Lattice& lattice, std::span<CellWord> cells) {
    for (CellWord& word : cells)
        if (word.is_empty()) word = CellWord::empty(CellWord::most_clearance);
    Bitmap near = occupied(lattice, cells), spread = near, scratch = near;
    for (int clearance = 0; clearance < CellWord::most_clearance; ++clearance) {
        spread_along_rows(lattice, near, spread);
        spread_across(lattice, 1, 0, spread, scratch);
        spread_across(lattice, 0, 1, scratch, spread);
        if (!write(clearance, spread, near, lattice, cells)) return;
        std::swap(near, spread);
    }
}

void measure_macro(const Lattice& lattice, std::span<CellWord> cells) {
    const auto blocks = [&](std::size_t axis) {
        return (lattice.cells()[axis] + macro_size - 1) / macro_size;
    };
    const auto visit_block = [&](const Cell& block) {
        CellRange range;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            range.first[axis] = block[axis] * macro_size;
            range.last[axis] = std::min(range.first[axis] + macro_size, lattice.cells()[axis]) - 1;
        }
        bool empty = true;
        for_each_cell(range, [&](const Cell& cell) {
            empty = empty && cells[lattice.number(cell)].is_empty();
        });
        if (empty)
            for_each_cell(
                range, [&](const Cell& cell) { cells[lattice.number(cell)] = CellWord::empty(1); });
    };
    tbb::parallel_for(0, blocks(2), [&](int z) {
        for_each_cell({{0, 0, z}, {blocks(0) - 1, blocks(1) - 1, z}}, visit_block);
    });
}

}  // namespace

void measure_clearance(Skip skip, const Lattice& lattice, std::span<CellWord> cells) {
    if (skip == Skip::distance) measure_distance(lattice, cells);
    if (skip == Skip::macro) measure_macro(lattice, cells);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
