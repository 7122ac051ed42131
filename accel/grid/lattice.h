#pragma once

#include "accel/core/box.h"

#include <cstddef>

/// Equal cells between equidistant planes. Planes are computed from their numbers by one formula,
/// so neighbouring cells share them bit for bit.
namespace rayshoot::inline RAYSHOOT_ISA {

/// How many cells a lattice has along each axis, or which of them: never negative.
using Cell = std::array<int, 3>;

/// Cells from `first` to `last`, both included.
struct CellRange {
    Cell first, last;

    std::size_t size() const {
        std::size_t cells = 1;
        for (std::size_t axis = 0; axis < 3; ++axis)
            cells *= static_cast<std::size_t>(last[axis] - first[axis] + 1);
        return cells;
    }
};

template <class Visit>
inline void for_each_cell(const CellRange& range, const Visit& visit) {
    for (int z = range.first[2]; z <= range.last[2]; ++z)
        for (int y = range.first[1]; y <= range.last[1]; ++y)
            for (int x = range.first[0]; x <= range.last[0]; ++x) visit(Cell{x, y, z});
}

class Lattice {
public:
    Lattice() = default;
    /// Its cells cover `space`, which is not empty.
    Lattice(const Box& space, const Cell& cells);

    const Cell& cells() const { return cells_; }
    std::size_t size() const { return CellRange{{0, 0, 0}, last()}.size(); }
    std::size_t number(const Cell& cell) const {
        const auto at = [](int place) { return static_cast<std::size_t>(place); };
        return (at(cell[2]) * at(cells_[1]) + at(cell[1])) * at(cells_[0]) + at(cell[0]);
    }
    Cell last() const { return {cells_[0] - 1, cells_[1] - 1, cells_[2] - 1}; }
    const vec3& lo() const { return lo_; }
    const vec3& step() const { return step_; }
    const vec3& per_step() const { return per_step_; }

    /// Lower plane of cell `i` along an axis, upper plane of cell i - 1. Rounded once, so a larger
    /// number never has a lower plane.
    float plane(int axis, int i) const {
        return std::fma(static_cast<float>(i), step_[axis], lo_[axis]);
    }
    Box box(const Cell& cell) const {
        Box box;
        for (int axis = 0; axis < 3; ++axis) {
            const int i = cell[static_cast<std::size_t>(axis)];
            box.lo[axis] = plane(axis, i);
            box.hi[axis] = plane(axis, i + 1);
        }
        return box;
    }

    /// The cell round a coordinate, give or take a rounding; the nearest one where there is none.
    int near(int axis, float x) const {
        const float place = (x - lo_[axis]) * per_step_[axis];
        const int end = cells_[static_cast<std::size_t>(axis)];
        if (!(place > 0)) return 0;
        return place < static_cast<float>(end) ? static_cast<int>(place) : end - 1;
    }
    /// The first and the last closed cell that touch a coordinate; the outer one where there is
    /// none.
    int first(int axis, float x) const;
    int last(int axis, float x) const;
    /// All closed cells that touch a box.
    CellRange around(const Box& box) const;
    /// Whether a plane across the axis goes through the coordinate.
    bool on_plane(int axis, float x) const;

private:
    vec3 lo_{0}, step_{1};
    vec3 per_step_{1};  ///< for guesses alone
    Cell cells_{1, 1, 1};
};

inline Lattice::Lattice(const Box& space, const Cell& cells) : lo_(space.lo), cells_(cells) {
    for (int axis = 0; axis < 3; ++axis) {
        int& number = cells_[static_cast<std::size_t>(axis)];
        const double size = double(space.hi[axis]) - double(space.lo[axis]);
        constexpr float largest = std::numeric_limits<float>::max();
        if (size > double(largest / 4)) {  // Four such steps exceed what a float holds.
            number = 4;
            step_[axis] = largest / 2;
        } else {
            step_[axis] = static_cast<float>(size / number);
            const float ulp = float_above(space.hi[axis]) - space.hi[axis];
            while (!(plane(axis, number) >= space.hi[axis]))
                step_[axis] = float_above(step_[axis] + ulp / static_cast<float>(number));
        }
        per_step_[axis] = 1 / step_[axis];
    }
}

inline int Lattice::first(int axis, float x) const {
    int i = near(axis, x);
    const int end = cells_[static_cast<std::size_t>(axis)] - 1;
    while (i < end && plane(axis, i + 1) < x) ++i;
    while (i > 0 && plane(axis, i) >= x) --i;
    return i;
}

inline int Lattice::last(int axis, float x) const {
    int i = near(axis, x);
    const int end = cells_[static_cast<std::size_t>(axis)] - 1;
    while (i > 0 && plane(axis, i) > x) --i;
    while (i < end && plane(axis, i + 1) <= x) ++i;
    return i;
}

inline CellRange Lattice::around(const Box& box) const {
    CellRange range;
    for (int axis = 0; axis < 3; ++axis) {
        range.first[static_cast<std::size_t>(axis)] = first(axis, box.lo[axis]);
        range.last[static_cast<std::size_t>(axis)] = last(axis, box.hi[axis]);
    }
    return range;
}

inline bool Lattice::on_plane(int axis, float x) const {
    const int i = first(axis, x);
    return plane(axis, i) == x || plane(axis, i + 1) == x;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
