#pragma once

#include "accel/octree/question.h"

/// Rays from so far away that their hits can be reported outside the cells of what they hit.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Visits every leaf below `cell` that the ray meets once all boxes are grown by `extra`
/// (Membership::extra). True: the question is answered.
template <class Question>
bool visit_grown(const Question& ask, const typename Question::Cell& cell, const Box& box,
                 float extra) {
    const Interval within = clip(ask.ray, box.grown(extra), {ask.ray.t_min, ask.hit.t});
    if (within.empty()) return false;
    if (!ask.interior(cell)) return ask.visit(cell);
    ask.step();
    for (unsigned i = 0; i < 8; ++i) {
        const unsigned child = i ^ ask.nearest;
        Box part = box;
        for (int axis = 0; axis < 3; ++axis)
            (child >> axis & 1 ? part.lo : part.hi)[axis] = ask.cells.plane(cell, axis);
        if (visit_grown(ask, ask.cells.child(cell, child), part, extra)) return true;
    }
    return false;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
