#pragma once

#include "accel/bsp/bsp.h"

/// From leaf to leaf along ropes, without a stack. A ray that meets two planes at once, or runs
/// inside one, may touch cells that no single rope leads to: it starts again with a stack.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The leaf below `node` that holds the ray's point at t; `none` where the point is on a plane.
template <Counter C>
inline std::uint32_t Bsp::leaf_at(const BspFlight& flight, std::uint32_t number, float t,
                                  C& count) const {
    for (BspNode node = tree_.nodes[number]; !node.is_leaf(); node = tree_.nodes[number]) {
        count(Event::step);
        const std::uint32_t axis = node.axis();
        const float at = (node.plane() - flight.origin[axis]) * flight.inverse[axis];
        const bool near = t<at, far = t> at;
        if (near == far) return RopedLeaf::outside;
        number = node.children() + (near ? flight.near_side[axis] : 1 - flight.near_side[axis]);
    }
    return number;
}

/// False where it takes a stack.
template <Query Q, Counter C>
inline bool Bsp::trace_along_ropes(BspFlight& flight, C& count) const {
    if (flight.node == BspFlight::nowhere) return true;
    const TestRay& ray = flight.ray;
    float t = flight.entry;
    for (std::uint32_t next = flight.node; next != RopedLeaf::outside;) {
        const std::uint32_t number = leaf_at(flight, next, t, count);
        if (number == RopedLeaf::outside) return false;
        const BspNode node = tree_.nodes[number];
        const RopedLeaf& leaf = ropes_[node.number()];
        std::array<float, 3> exits;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            exits[i] = ray.at(axis, ray.descending[i] ? leaf.box.lo[axis] : leaf.box.hi[axis]);
        }
        const std::size_t first = exits[1] < exits[0] ? 1 : 0;
        const std::size_t axis = exits[2] < exits[first] ? 2 : first;
        for (std::size_t other = 0; other < 3; ++other)
            if (other != axis && !(exits[axis] < exits[other])) return false;
        if (!(t < exits[axis])) return false;
        visit_leaf<Q>(flight, node, count);
        t = exits[axis];
        // Closed: what begins exactly at the hit may hold a tie with a smaller number.
        if (flight.over<Q>() || flight.hit.t < t) return true;
        next = leaf.ropes[ray.far[axis]];
    }
    return true;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
