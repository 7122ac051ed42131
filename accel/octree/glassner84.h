#pragma once

#include "accel/octree/stops.h"

/// Glassner 1984: every leaf is looked for from the root.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where Glassner hashes the names of cells we go down to them, as Havran 1999 did; and where he
/// takes a point just behind the face, by a distance less than the smallest cell's side, we ask
/// on which side of each plane the ray is just after t (stops.h).
template <class Question>
void glassner84(const Question& ask) {
    from_stop_to_stop(ask, [&](float t) {
        OctreeDescent<typename Question::Cell> at{ask.cells.root(), ask.within.exit};
        while (ask.interior(at.cell)) {
            ask.step();
            descend(ask, at, t);
        }
        return at;
    });
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
