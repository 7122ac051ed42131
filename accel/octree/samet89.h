#pragma once

#include "accel/octree/stops.h"

/// Neighbour finding (Samet 1989): up to the nearest common ancestor, and down again.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The common ancestor is the smallest cell that the ray leaves later. The way down is remembered,
/// where Samet follows pointers to parents. Steps are counted as his algorithm makes them: to every
/// cell on the way up, the common ancestor among them; to those below it on the way down; and again
/// from a neighbour of the size of the leaf, where that is cut, because there a new search begins.
template <class Question>
void samet89(const Question& ask) {
    using Place = OctreeDescent<typename Question::Cell>;
    std::array<Place, OctreeLattice::most_levels + 1> way;
    way[0] = {ask.cells.root(), ask.within.exit};
    std::size_t level = 0;
    from_stop_to_stop(ask, [&](float t) {
        const std::size_t last = level;
        while (level > 0 && !(way[level].exit > t)) {
            --level;
            ask.step();
        }
        const std::size_t common = level;
        way[level].planes_at_entry = 0;  // crossed before t, as the cell was entered before
        while (ask.interior(way[level].cell)) {
            if (level > common || common == last) ask.step();
            if (level == last && level > common) ask.step();
            way[level + 1] = way[level];
            descend(ask, way[++level], t);
        }
        return way[level];
    });
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
