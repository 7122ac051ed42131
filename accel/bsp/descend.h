#pragma once

#include "accel/bsp/flight.h"
#include "accel/core/raw_array.h"

/// One ray from the root to its hit: the recursive descent, with a stack for what is left for
/// later.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Tests all that a leaf holds.
template <Query Q, Counter C>
inline void visit_leaf(const PackedLeaves& leaves, BspFlight& flight, BspNode leaf, C& count) {
    count(Event::cell);
    if constexpr (C::counts) count(Event::empty_cell, leaf.is_empty());
    if (!leaf.is_empty()) leaves.template test<Q>(leaf.leaf(), flight.ray, flight.hit, count);
}

/// Where a ray meets a node's plane.
struct BspMeeting {
    float t;
    std::uint32_t near_side;  ///< 1: the ray comes from above the plane
};

/// meet(node): a BspMeeting; visit(leaf): the flight's cell, with all it holds.
template <Query Q, class Meet, class Visit, Counter C>
inline void descend(BspFlight& flight, const RawArray<BspNode>& nodes, const Meet& meet,
                    const Visit& visit, C& count) {
    do {
        BspNode node = nodes[flight.node];
        while (!node.is_leaf()) {
            count(Event::step);
            const BspMeeting at = meet(node);
            const BspCrossing plane(at.t, flight.entry, flight.exit);
            const std::uint32_t near = node.children() + at.near_side, far = near ^ 1;
            if (plane.near && plane.far) {
                flight.halts[++flight.top] = {far, plane.far_entry(flight.entry), flight.exit};
                flight.exit = plane.near_exit(flight.exit);
            }
            node = nodes[plane.near ? near : far];
        }
        visit(node);
    } while (!flight.over<Q>() && flight.pop());
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
