#pragma once

#include "accel/bvh8/bvh8.h"

/// One ray from the root to its hit. Branches rather than selections: what the processor guesses
/// right, it need not wait for.
namespace rayshoot::inline RAYSHOOT_ISA {

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::trace_alone(Flight& flight, C& count) const {
    while (!flight.next.is_none()) {
        if (!flight.next.interior()) {
            visit_leaf<Q>(flight, count);
            if constexpr (Q == Query::occluded)
                if (flight.hit.primitive != no_primitive) return;
            flight.pop();
            continue;
        }
        const Node& node = node_at(flight.next);
        const Children children = meet(flight, node, count);
        std::uint32_t places = children.places;
        if (places == 0) {
            flight.pop();
            continue;
        }
        auto place = static_cast<std::size_t>(std::countr_zero(places));
        flight.next = node.child(place);
        fetch(flight.next);
        places &= places - 1;
        if (places == 0) continue;
        alignas(32) std::array<float, Node::width> entries;
        simd::hn::Store(children.entry, simd::floats<Node::width>, entries.data());
        float nearest = entries[place];
        do {
            place = static_cast<std::size_t>(std::countr_zero(places));
            places &= places - 1;
            const WideChild other = node.child(place);
            fetch(other);
            if (Q == Query::closest && entries[place] < nearest) {
                flight.stack.push(flight.next, nearest);
                flight.next = other;
                nearest = entries[place];
            } else {
                flight.stack.push(other, entries[place]);
            }
        } while (places != 0);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
