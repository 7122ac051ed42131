#pragma once

#include "accel/octree/question.h"

#include <bit>

/// The parametric traversal of Revelles, Urena & Lastra 2000: the first child and each next one
/// follow from comparing the parameters of planes.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Their Table 1: the child that the ray is in when it enters the cell. The axis whose plane it
/// enters through does not matter, as that plane's cut lies behind the entry; so a bit is set where
/// the cut lies before it. The published table has the bits of x and z exchanged (the authors'
/// erratum); ours has bit 0 for x. A cut exactly at the entry counts as still to come.
inline unsigned first_child(const std::array<float, 3>& cuts, float entry) {
    return (cuts[0] < entry ? 1u : 0) | (cuts[1] < entry ? 2u : 0) | (cuts[2] < entry ? 4u : 0);
}

/// Where a ray leaves a child: their Table 2, but for ties. In the paper the least of three
/// parameters says which bit is set next.
struct OctreeChildExit {
    float t;
    unsigned axes;  ///< whose cuts are crossed at t, a bit each

    OctreeChildExit(unsigned child, const std::array<float, 3>& cuts, float cell_exit)
        : t(cell_exit), axes(0) {
        for (unsigned axis = 0; axis < 3; ++axis) {
            if (child >> axis & 1 || !(cuts[axis] <= t)) continue;  // nor NaN
            axes = cuts[axis] < t ? 1u << axis : axes | 1u << axis;
            t = cuts[axis];
        }
    }
};

template <class Question>
bool parametric(const Question& ask, const typename Question::Cell& cell, const Interval& span);

/// A child of a cell, and with it those whose numbers have more bits set, of `axes`.
template <class Question>
bool enter(const Question& ask, const typename Question::Cell& cell, unsigned child, unsigned axes,
           const Interval& part) {
    for (unsigned subset = 0;; subset = (subset - axes) & axes) {
        const auto below = ask.cells.child(cell, (child | subset) ^ ask.nearest);
        if (parametric(ask, below, part)) return true;
        if (subset == axes) return false;
    }
}

/// `span`: where the ray is in the cell, closed. Planes are those of the cells, not means of two
/// parameters as in the paper, so that neighbours agree on them bit for bit. Where several cuts are
/// crossed at once, the children that the ray only touches there are visited too; where it runs
/// inside a cut, both sides are. True: the question is answered.
template <class Question>
bool parametric(const Question& ask, const typename Question::Cell& cell, const Interval& span) {
    if (!ask.interior(cell)) return ask.visit(cell);
    ask.step();
    const std::array<float, 3> cuts{ask.crossing(cell, 0), ask.crossing(cell, 1),
                                    ask.crossing(cell, 2)};
    const unsigned inside = (std::isnan(cuts[0]) ? 1u : 0) | (std::isnan(cuts[1]) ? 2u : 0) |
                            (std::isnan(cuts[2]) ? 4u : 0);
    unsigned child = first_child(cuts, span.entry);
    float entry = span.entry;
    while (ask.reaches(entry)) {
        const OctreeChildExit exit(child, cuts, span.exit);
        if (enter(ask, cell, child, inside, {entry, exit.t})) return true;
        if (exit.axes == 0) return false;
        const bool touches_others = std::popcount(exit.axes) > 1;
        if (touches_others && enter(ask, cell, child, exit.axes | inside, {exit.t, exit.t}))
            return true;
        child |= exit.axes;
        entry = exit.t;
    }
    return false;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
