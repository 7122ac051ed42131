#pragma once

#include "accel/grid/lattice.h"

#include <algorithm>

/// The cells of a lattice that a ray goes through, in order (Fujimoto, Tanaka & Iwata 1986;
/// Amanatides & Woo 1987). What is stepped are integers, and each parameter is computed anew from a
/// plane's number: nothing drifts.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where a ray meets the planes of a lattice.
struct PlaneCrossings {
    const Lattice& lattice;
    const SlabRay& ray;

    /// The plane by which the ray enters cell `i` along an axis, and the one by which it leaves.
    float enter(int axis, int i) const {
        return ray.at(axis, lattice.plane(axis, i + descending(axis)));
    }
    float leave(int axis, int i) const {
        return ray.at(axis, lattice.plane(axis, i + 1 - descending(axis)));
    }
    /// The first cell along an axis, in the ray's order, that it does not leave before t.
    int first(int axis, float t) const;
    int stride(int axis) const { return 1 - 2 * descending(axis); }
    /// Where the ray's order of cells ends: no cell.
    int end(int axis) const {
        const int cells = lattice.cells()[static_cast<std::size_t>(axis)];
        return descending(axis) ? -1 : cells;
    }
    int descending(int axis) const { return ray.descending[static_cast<std::size_t>(axis)]; }
};

inline int PlaneCrossings::first(int axis, float t) const {
    const int forward = stride(axis), beyond = end(axis);
    const int last = beyond - forward;
    const int start = lattice.cells()[static_cast<std::size_t>(axis)] - 1 - last;
    int i = start;
    if (ray.inverse[axis] - ray.inverse[axis] == 0 && t > -infinity)
        i = lattice.near(axis, std::fma(t, 1 / ray.inverse[axis], ray.origin[axis]));
    else if (t > -infinity) i = lattice.near(axis, ray.origin[axis]);
    while (i != last && leave(axis, i) < t) i += forward;
    while (i != start && leave(axis, i - forward) >= t) i -= forward;
    return i;
}

/// For rays that run inside no plane: a parameter is never NaN.
class Walk {
public:
    /// Begins where the ray is at t, somewhere between its entry into the lattice and its exit.
    Walk(const Lattice& lattice, const SlabRay& ray, float t) : cross_{lattice, ray} {
        for (int axis = 0; axis < 3; ++axis) {
            cell_[at(axis)] = cross_.first(axis, t);
            leave_[at(axis)] = cross_.leave(axis, cell_[at(axis)]);
        }
    }

    const Cell& cell() const { return cell_; }
    /// Where the ray leaves the cell.
    float exit() const { return std::min(std::min(leave_[0], leave_[1]), leave_[2]); }
    /// The axes along which it leaves there, a bit each: several are tied.
    unsigned axes_out() const {
        const float t = exit();
        return unsigned{leave_[0] == t} | unsigned{leave_[1] == t} << 1 |
               unsigned{leave_[2] == t} << 2;
    }
    /// Goes to the next cell along an axis; false where there is none.
    bool step(int axis) {
        int& i = cell_[at(axis)];
        i += cross_.stride(axis);
        if (i == cross_.end(axis)) return false;
        leave_[at(axis)] = cross_.leave(axis, i);
        return true;
    }
    /// Where several axes are tied: the ray touches a block of cells at one t. Visits all of them
    /// but the one that it leaves, then goes to the last one; false where that is outside.
    template <class Visit>
    bool cross_block(const Visit& visit);
    /// Goes to the last cell, or the first of several tied ones, that the ray touches of a range
    /// round the present one.
    void leap(const CellRange& range);

private:
    static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

    PlaneCrossings cross_;
    Cell cell_;
    std::array<float, 3> leave_;
};

template <class Visit>
inline bool Walk::cross_block(const Visit& visit) {
    const float t = exit();
    const Cell from = cell_;
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
        while (leave_[at(axis)] == t) {
            if (step(axis)) continue;
            cell_[at(axis)] -= cross_.stride(axis);
            inside = false;
            break;
        }
    const Cell to = cell_;
    const auto each = [&](int axis, const auto& next) {
        const int forward = cross_.stride(axis);
        for (int i = from[at(axis)]; i != to[at(axis)] + forward; i += forward) next(i);
    };
    each(2, [&](int z) {
        each(1, [&](int y) {
            each(0, [&](int x) {
                if (Cell{x, y, z} != from) visit(Cell{x, y, z});
            });
        });
    });
    return inside;
}

inline void Walk::leap(const CellRange& range) {
    float t = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const int rim = cross_.descending(axis) ? range.first[at(axis)] : range.last[at(axis)];
        t = std::min(t, cross_.leave(axis, rim));
    }
    // Of cells that are left at the same t the first, on every axis: tied ones are a block, parts
    // of which may lie beyond the range. But never back.
    for (int axis = 0; axis < 3; ++axis) {
        const int first = cross_.first(axis, t);
        if ((first - cell_[at(axis)]) * cross_.stride(axis) <= 0) continue;
        cell_[at(axis)] = first;
        leave_[at(axis)] = cross_.leave(axis, first);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
