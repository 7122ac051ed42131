#pragma once

#include "accel/bvh8/bvh8.h"
#include "accel/simd/rays_by_blocks.h"

/// Many rays on their way at once: each in turn takes one step, whose memory was asked for a round
/// before. No branch depends on a ray, so that the steps of several rays overlap.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Which children the ray meets, and which of them first.
template <class Node>
template <Counter C>
inline void WideBvh<Node>::cross(Flight& flight, C& count) const {
    using namespace simd;
    constexpr auto tag = floats<Node::width>;
    const Node& node = node_at(flight.next);
    const Children children = meet(flight, node, count);
    hn::Store(children.entry, tag, flight.crossing.entries.data());
    flight.crossing.node = &node;
    flight.crossing.places = children.places;
    flight.crossing.nearest = nearest_of(children.met, children.entry);
}

/// Goes on to the nearest child that is met, or else to what was left behind last; the other
/// children are left behind in any order. What is popped here was pushed in an earlier round: a
/// value that has just been stored as part of a vector would have to be waited for.
template <class Node>
inline void go_down(Flight<Node>& flight) {
    using namespace simd;
    const auto& crossing = flight.crossing;
    const std::uint32_t nearest = crossing.nearest;
    const std::uint32_t places = crossing.places, others = places & ~(1u << nearest);
    const WideChild left_behind = flight.stack.top();
    flight.stack.push(
        static_cast<std::size_t>(std::popcount(places)),
        compress(hn::Load(words<Node::width>, crossing.node->children.data()), others),
        compress(hn::Load(floats<Node::width>, crossing.entries.data()), others));
    flight.stack.drop();
    flight.next = WideChild::from(static_cast<std::uint32_t>(
        simd::select(places != 0, crossing.node->child(nearest).bits(), left_behind.bits())));
}

/// Flights, a bit each, by what they come to next. Not lists: what is read from a list would have
/// to wait until it is known that nothing writes there.
struct Departures {
    std::uint64_t to_node = 0, to_leaf = 0;
    /// Of leaves: those of triangles and of spheres, which are tested for several flights at once,
    /// the mixed ones, and where there is none left.
    std::uint64_t to_triangles = 0, to_spheres = 0, to_mixed = 0, to_end = 0;

    bool any() const {
        return (to_node | to_leaf | to_triangles | to_spheres | to_mixed | to_end) != 0;
    }
    void add(std::size_t flight, WideChild next) {
        const std::uint64_t leaf = !next.interior();
        to_node |= (leaf ^ 1) << flight;
        to_leaf |= leaf << flight;
    }
    template <class Node>
    void sort_leaves(const Flight<Node>* flights) {
        simd::for_each(std::exchange(to_leaf, 0), [&](std::size_t flight) {
            const WideChild next = flights[flight].next;
            const std::uint64_t end = next.is_none();
            const std::uint64_t triangles = next.leaf().only_triangles();
            const std::uint64_t mixed = next.leaf().is_mixed();
            to_triangles |= triangles << flight;
            to_mixed |= mixed << flight;
            to_spheres |= (1 ^ triangles ^ mixed ^ end) << flight;
            to_end |= end << flight;
        });
    }
};

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::trace_in_flight(const Part& part, Answers<Q>& answers, Scratch& scratch,
                                           C& count) const {
    Flight* const flights = scratch.flights.data();
    Departures departures;
    std::size_t started = 0;
    const auto start_next = [&](std::size_t number) {
        if (started == part.rays.size()) return;
        flights[number].start(part.rays[started], started, leaves_.precision());
        departures.add(number, flights[number].next);
        ++started;
    };
    const auto go_on = [&](std::size_t number) {
        const WideChild next = flights[number].next;
        fetch(next);
        departures.add(number, next);
    };
    for (std::size_t i = 0; i < in_flight_; ++i) start_next(i);
    while (departures.any()) {
        const std::uint64_t at_node = std::exchange(departures.to_node, 0);
        // Two short loops: the processor looks ahead over more rays in each than in one long loop.
        simd::for_each(at_node, [&](std::size_t number) { cross(flights[number], count); });
        simd::for_each(at_node, [&](std::size_t number) {
            go_down(flights[number]);
            go_on(number);
        });
        departures.sort_leaves(flights);
        visit_blocks<Q, TriangleBlock>(departures.to_triangles, departures, flights, count);
        visit_blocks<Q, SphereBlock>(departures.to_spheres, departures, flights, count);
        simd::for_each(std::exchange(departures.to_mixed, 0), [&](std::size_t number) {
            Flight& flight = flights[number];
            visit_leaf<Q>(flight, count);
            flight.pop();
            if (Q == Query::occluded && flight.hit.primitive != no_primitive)
                flight.next = WideChild::none();
            go_on(number);
        });
        simd::for_each(std::exchange(departures.to_end, 0), [&](std::size_t number) {
            answers.store(part.first + flights[number].number, flights[number].hit);
            start_next(number);
        });
    }
}

/// One block of each leaf, for as many flights at once as there are; fewer only where no other
/// flight goes on.
template <class Node>
template <Query Q, class Block, Counter C>
inline void WideBvh<Node>::visit_blocks(std::uint64_t& waiting, Departures& departures,
                                        Flight* flights, C& count) const {
    while (static_cast<std::size_t>(std::popcount(waiting)) >= rays_by_blocks ||
           (waiting != 0 && departures.to_node == 0)) {
        RaysAndBlocks<Block> pairs;
        std::array<std::size_t, rays_by_blocks> numbers;
        std::size_t together = 0;
        for (; together < rays_by_blocks && waiting != 0; ++together) {
            numbers[together] = static_cast<std::size_t>(std::countr_zero(waiting));
            waiting &= waiting - 1;
            Flight& flight = flights[numbers[together]];
            pairs[together] = {&flight.ray, &flight.hit,
                               &leaves_.block<Block>(flight.next.leaf().first_block())};
        }
        const float padding = leaves_.padding();
        constexpr Misses misses = Q == Query::closest ? Misses::go_on : Misses::leave;
        if constexpr (std::is_same_v<Block, SphereBlock>)
            test<misses>(pairs, together, padding, count);
        else if (leaves_.precision() == Precision::standard)
            test<Precision::standard, misses, Q>(pairs, together, padding, count);
        else test<Precision::watertight, misses, Q>(pairs, together, padding, count);
        for (std::size_t i = 0; i < together; ++i) {
            Flight& flight = flights[numbers[i]];
            const PackedLeaf leaf = flight.next.leaf();
            const bool last = leaf.block_count() == 1;
            const bool over = Q == Query::occluded && flight.hit.primitive != no_primitive;
            if constexpr (C::counts) count(Event::cell, last || over);
            if constexpr (Q == Query::closest) flight.pop();
            else flight.pop_any();
            if (!last) [[unlikely]] {
                flight.stack.push(flight.next, -infinity);
                flight.next = WideChild::leaf(leaf.after_first());
            }
            if constexpr (Q == Query::occluded)
                flight.next = WideChild::from(static_cast<std::uint32_t>(
                    simd::select(over, WideChild::none().bits(), flight.next.bits())));
            fetch(flight.next);
            departures.add(numbers[i], flight.next);
        }
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
