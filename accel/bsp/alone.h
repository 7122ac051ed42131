#pragma once

#include "accel/bsp/bsp.h"

/// One ray from the root to its hit.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Counter C>
inline void Bsp::trace_alone(BspFlight& flight, C& count) const {
    descend<Q>(
        flight, tree_.nodes,
        [&](BspNode node) {
            const std::uint32_t axis = node.axis();
            return BspMeeting{(node.plane() - flight.origin[axis]) * flight.inverse[axis],
                              flight.near_side[axis]};
        },
        [&](BspNode leaf) { visit_leaf<Q>(flight, leaf, count); }, count);
}

/// All leaves of the sub-trees whose outlines the ray meets.
template <Query Q, Counter C>
inline void Bsp::trace_from_afar(BspFlight& flight, float t_min, C& count) const {
    const auto visit = [&](BspNode leaf) {
        visit_leaf<Q>(flight, leaf, count);
        return flight.over<Q>();
    };
    each_leaf(tree_, outlines_, flight.ray, t_min, flight.hit, visit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
