#pragma once

#include "accel/octree/question.h"

/// From leaf to leaf: the ray stops where it leaves one, and the next one is found there.
namespace rayshoot::inline RAYSHOOT_ISA {

/// On the way to the leaf that the ray is in just after t. No point is computed and no distance
/// added to it: planes are compared with t by where the ray crosses them, so what is found is a
/// fact about floats.
template <class Cell>
struct OctreeDescent {
    Cell cell;
    float exit;                    ///< where the ray leaves it
    unsigned planes_at_exit = 1;   ///< that the ray crosses there
    unsigned planes_at_entry = 0;  ///< that it crosses exactly at t
    bool inside_plane = false;     ///< it runs in one of the planes

    /// Whether the ray can only go on from here to one other leaf.
    bool plain() const { return planes_at_exit == 1 && !inside_plane; }
};

/// To the child that the ray is in just after t.
template <class Question, class Cell = typename Question::Cell>
void descend(const Question& ask, OctreeDescent<Cell>& at, float t) {
    unsigned child = ask.nearest;
    for (int axis = 0; axis < 3; ++axis) {
        const float crossing = ask.crossing(at.cell, axis);
        if (crossing <= t) {
            child ^= 1u << axis;
            at.planes_at_entry += crossing == t;
        } else if (crossing < at.exit) {
            at.exit = crossing;
            at.planes_at_exit = 1;
        } else {
            at.planes_at_exit += crossing == at.exit;
            at.inside_plane |= std::isnan(crossing);
        }
    }
    at.cell = ask.cells.child(at.cell, child);
}

/// Visits every leaf below `cell` that the ray touches at t, in corners and edges too.
/// `exit`: where the ray leaves the cell; `next`: set to the first exit behind t, if that is less.
/// True: the question is answered.
template <class Question>
bool visit_block(const Question& ask, const typename Question::Cell& cell, float exit, float t,
                 float& next) {
    if (!ask.interior(cell)) {
        next = exit > t && exit < next ? exit : next;
        return ask.visit(cell);
    }
    ask.step();
    for (unsigned i = 0; i < 8; ++i) {
        float child_exit = exit;
        bool touched = true;
        for (int axis = 0; axis < 3; ++axis) {
            const float crossing = ask.crossing(cell, axis);
            if (i >> axis & 1) {
                touched &= !(crossing > t);
            } else {
                touched &= !(crossing < t);
                child_exit = crossing < child_exit ? crossing : child_exit;
            }
        }
        if (touched &&
            visit_block(ask, ask.cells.child(cell, i ^ ask.nearest), child_exit, t, next))
            return true;
    }
    return false;
}

/// `locate(t)`: the OctreeDescent to the leaf that the ray is in just after t; t never decreases.
///
/// If the ray left the last leaf through one plane, and crosses one plane on the descent to the
/// next leaf at that t, it is the same plane, and no other leaf contains the point: a third one
/// would be on another side of a plane than one of the two, and the ray would cross that at t as
/// well. In any other case the whole block of leaves that meet there is visited.
template <class Question, class Locate>
void from_stop_to_stop(const Question& ask, Locate&& locate) {
    float t = ask.within.entry;
    bool plain = true;
    unsigned planes = 0;  // to be crossed at t: none yet
    while (true) {
        const auto at = locate(t);
        float next = at.exit;
        if (plain && at.planes_at_entry == planes && !at.inside_plane) {
            if (ask.visit(at.cell)) return;
        } else {
            next = infinity;
            if (visit_block(ask, ask.cells.root(), ask.within.exit, t, next)) return;
        }
        plain = at.plain();
        planes = 1;
        const bool outside = next == ask.within.exit && plain;
        if (outside || !(next > t) || !ask.reaches(next) || next > ask.within.exit) return;
        t = next;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
