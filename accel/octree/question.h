#pragma once

#include "accel/octree/lists.h"

/// What every traversal of an octree is given: one ray, the cells, and what to do at a leaf.
namespace rayshoot::inline RAYSHOOT_ISA {

/// `Cells`: OctreeNodes or LinearOctree.
template <class Cells, Query Q, Counter C>
struct OctreeQuestion {
    using Cell = typename Cells::Cell;

    const Cells& cells;
    const OctreeLeaves& leaves;
    const TestRay& ray;
    Interval within;  ///< of the ray in the whole space, from t_min on
    Hit& hit;
    C& count;
    /// The child in which a ray begins that crosses no plane yet. Crossing the plane of an axis
    /// flips the axis' bit (Revelles et al. 2000 mirror the ray instead).
    unsigned nearest = ray.descending[0] * 1u | ray.descending[1] * 2u | ray.descending[2] * 4u;

    bool interior(const Cell& cell) const { return cells.interior(cell); }
    /// A plane of an interior cell, by where the ray crosses it. NaN: the ray runs inside it.
    float crossing(const Cell& cell, int axis) const {
        return ray.at(axis, cells.plane(cell, axis));
    }
    /// Closed: what begins exactly at the hit may hold a tie with a smaller number.
    bool reaches(float t) const { return t <= hit.t; }

    /// A step from an interior cell to some of its children.
    void step() const { count(Event::step); }
    /// Tests the members of a leaf. True: the question is answered.
    bool visit(const Cell& cell) const {
        const std::uint32_t leaf = cells.leaf(cell);
        count(Event::step);
        count(Event::cell);
        if (leaf == empty_leaf) {
            count(Event::empty_cell);
            return false;
        }
        leaves.template test<Q>(leaf, ray, hit, count);
        return Q == Query::occluded && hit.primitive != no_primitive;
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
