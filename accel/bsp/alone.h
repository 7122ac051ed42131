#pragma once

#include "accel/bsp/bsp.h"

/// One ray from the root to its hit: the recursive descent, with a stack for what is left for
/// later.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Counter C>
inline void Bsp::trace_alone(BspFlight& flight, C& count) const {
    do {
        BspNode node = tree_.nodes[flight.node];
        while (!node.is_leaf()) {
            count(Event::step);
            const std::uint32_t axis = node.axis();
            const BspCrossing plane((node.plane() - flight.origin[axis]) * flight.inverse[axis],
                                    flight.entry, flight.exit);
            const std::uint32_t near = node.children() + flight.near_side[axis], far = near ^ 1;
            if (plane.near && plane.far) {
                flight.halts[++flight.top] = {far, plane.far_entry(flight.entry), flight.exit};
                flight.exit = plane.near_exit(flight.exit);
            }
            node = tree_.nodes[plane.near ? near : far];
        }
        visit_leaf<Q>(flight, node, count);
    } while (!flight.over<Q>() && flight.pop());
}

/// All leaves of the sub-trees whose outlines the ray meets.
template <Query Q, Counter C>
inline void Bsp::trace_from_afar(BspFlight& flight, float t_min, C& count) const {
    const auto visit_all = [&](std::uint32_t root) {
        std::array<std::uint32_t, deepest_bsp + 2> later;
        std::size_t size = 0;
        later[size++] = root;
        while (size > 0 && !flight.over<Q>()) {
            const BspNode node = tree_.nodes[later[--size]];
            if (node.is_leaf()) {
                visit_leaf<Q>(flight, node, count);
                continue;
            }
            count(Event::step);
            later[size++] = node.children() + 1;
            later[size++] = node.children();
        }
        return flight.over<Q>();
    };
    outlines_.each(
        flight.ray, t_min, flight.hit, [&](std::uint32_t root) { return visit_all(root); }, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
