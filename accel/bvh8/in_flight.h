#pragma once

#include "accel/bvh8/bvh8.h"

/// Many rays on their way at once: each in turn takes one step, whose memory was asked for a round
/// before. A step has no branch that depends on the ray, so that steps of several rays overlap.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Pushes the children that are met, the nearest one on top, the others in any order.
template <Query Q>
inline void push_all(Flight& flight, const WideNode& node, auto entry, auto met,
                     std::uint32_t places) {
    using namespace simd;
    constexpr auto tag = floats<WideNode::width>;
    constexpr auto word = words<WideNode::width>;
    const auto child = hn::Load(word, node.children.data());
    std::uint32_t* children = &flight.children[flight.top];
    float* entries = &flight.entries[flight.top];
    flight.top += static_cast<std::size_t>(std::popcount(places));
    if constexpr (Q == Query::occluded) {
        hn::StoreU(compress(child, places), word, children);
        hn::StoreU(compress(entry, places), tag, entries);
        return;
    }
    const auto distance = hn::IfThenElse(met, entry, hn::Set(tag, infinity));
    const auto least = hn::MinOfLanes(tag, distance);
    const std::uint32_t nearest = bits(tag, hn::Eq(distance, least)) & places;
    const std::uint32_t first = nearest & (0u - nearest), others = places ^ first;
    hn::StoreU(compress(child, others), word, children);
    hn::StoreU(compress(entry, others), tag, entries);
    if (places == 0) return;
    flight.children[flight.top - 1] =
        node.children[static_cast<std::size_t>(std::countr_zero(first))];
    flight.entries[flight.top - 1] = hn::GetLane(least);
}

/// Which flights are at an interior node, and which at a leaf or the end of their way. A list is
/// read and filled again at once: what is written never overtakes what is read.
struct Departures {
    std::array<std::uint8_t, Bvh8::most_flights> at_node, at_leaf;
    std::size_t nodes = 0, leaves = 0;

    void add(std::uint8_t flight, bool interior) {
        at_node[nodes] = at_leaf[leaves] = flight;
        nodes += interior;
        leaves += !interior;
    }
};

template <Query Q, Counter C>
inline void Bvh8::trace_in_flight(const Part& part, Answers<Q>& answers, Scratch& scratch,
                                  C& count) const {
    Departures flights;
    std::size_t started = 0;
    const auto start = [&](std::uint8_t number) {
        if (started == part.rays.size()) return;
        scratch.flights[number].start(part.rays[started], part.best(started), started, precision_);
        ++started;
        flights.add(number, true);
    };
    const auto go_on = [&](std::uint8_t number) {
        const WideChild next = scratch.flights[number].next;
        fetch(next);
        flights.add(number, next.interior());
    };
    for (std::size_t i = 0; i < in_flight_; ++i) start(static_cast<std::uint8_t>(i));
    while (flights.nodes + flights.leaves > 0) {
        const std::size_t at_nodes = std::exchange(flights.nodes, 0);
        for (std::size_t i = 0; i < at_nodes; ++i) {
            const std::uint8_t number = flights.at_node[i];
            Flight& flight = scratch.flights[number];
            const WideNode& node = nodes_[flight.next.number()];
            const Children children = meet(flight, node, count);
            push_all<Q>(flight, node, children.entry, children.met, children.places);
            flight.pop();
            go_on(number);
        }
        const std::size_t at_leaves = std::exchange(flights.leaves, 0);
        for (std::size_t i = 0; i < at_leaves; ++i) {
            const std::uint8_t number = flights.at_leaf[i];
            Flight& flight = scratch.flights[number];
            if (flight.next.is_none()) {
                answers.store(part.first + flight.number, flight.hit);
                start(number);
                continue;
            }
            visit_leaf<Q>(flight, count);
            const bool over = Q == Query::occluded && flight.hit.primitive != no_primitive;
            if (over) flight.next = WideChild::none();
            else flight.pop();
            go_on(number);
        }
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
