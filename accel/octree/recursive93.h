#pragma once

#include "accel/octree/question.h"

/// Recursive traversal from the root (HERO: Agate, Grimsdale & Lister 1991; Gargantini & Atkinson
/// 1993).
namespace rayshoot::inline RAYSHOOT_ISA {

/// `span`: where the ray is in the cell, closed. Children in the order of their numbers are in the
/// order of the ray, once bits are flipped where it descends: those it leaves come before those it
/// enters. A child belongs to the ray if its part of the span is not empty; a single point is not.
/// True: the question is answered.
template <class Question>
bool recursive93(const Question& ask, const typename Question::Cell& cell, const Interval& span) {
    if (!ask.interior(cell)) return ask.visit(cell);
    ask.step();
    const std::array<float, 3> crossing{ask.crossing(cell, 0), ask.crossing(cell, 1),
                                        ask.crossing(cell, 2)};
    for (unsigned i = 0; i < 8; ++i) {
        Interval part = span;
        for (unsigned axis = 0; axis < 3; ++axis) {  // NaN bounds nothing
            const float t = crossing[axis];
            if (i >> axis & 1) part.entry = t > part.entry ? t : part.entry;
            else part.exit = t < part.exit ? t : part.exit;
        }
        if (part.empty() || !ask.reaches(part.entry)) continue;
        if (recursive93(ask, ask.cells.child(cell, i ^ ask.nearest), part)) return true;
    }
    return false;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
