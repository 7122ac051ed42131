#pragma once

#include "accel/octree/stops.h"

/// Neighbour finding (Samet 1989): up to the nearest common ancestor, and down again.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The common ancestor is the smallest cell that the ray leaves later. The way down is remembered,
/// where Samet follows pointers to parents.
template <class Question>
void samet89(const Question& ask) {
    using Place = Descent<typename Question::Cell>;
    std::array<Place, Lattice::most_levels + 1> way;
    way[0] = {ask.cells.root(), ask.within.exit};
    std::size_t level = 0;
    from_stop_to_stop(ask, [&](float t) {
        while (level > 0 && !(way[level].exit > t)) {
            --level;
            ask.step();
        }
        way[level].planes_at_entry = 0;  // crossed before t, as the cell was entered before
        while (ask.interior(way[level].cell)) {
            way[level + 1] = way[level];
            descend(ask, way[++level], t);
        }
        return way[level];
    });
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
