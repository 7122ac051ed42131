#pragma once

#include "accel/bsp/bsp.h"

/// Many rays on their way at once, a lane each of a few fleets. While a fleet's nodes are fetched
/// the others move.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Counter C>
inline void Bsp::trace_in_flight(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                                 C& count) const {
    const std::span<Fleet> fleets(scratch.fleets.data(), fleets_);
    std::size_t started = 0, landed = 0;
    // Ends the lanes' rays, and starts others.
    const auto relieve = [&](Fleet& fleet, FleetLanes lanes) {
        simd::for_each(lanes, [&](std::size_t lane) {
            if ((fleet.idle >> lane & 1) == 0) {
                const Fleet::Passenger& passenger = fleet.passengers[lane];
                answers.store(part.first + passenger.number, passenger.hit);
                ++landed;
            }
            fleet.idle |= 1u << lane;
            fleet.node[lane] = BspFlight::nowhere;
            if (started == part.rays.size()) return;
            fleet.start(lane, part.rays[started], started, tree_.leaves.precision(), space_);
            ++started;
        });
    };
    for (Fleet& fleet : fleets) relieve(fleet, Fleet::all);
    while (landed < part.rays.size())
        for (Fleet& fleet : fleets) {
            if (fleet.idle == Fleet::all) continue;
            const FleetLanes before = fleet.waiting | fleet.idle;
            if constexpr (C::counts) count_steps(fleet, count);
            const FleetLanes at_leaf = fleet.step(tree_.nodes.data());
            FleetLanes over = 0;
            visit_leaves<Q>(fleet, at_leaf & ~before, over, count);
            visit_blocks<Q, TriangleBlock>(fleet, fleet.to_triangles, over, count);
            visit_blocks<Q, SphereBlock>(fleet, fleet.to_spheres, over, count);
            visit_mixed<Q>(fleet, over, count);
            relieve(fleet, over);
            for (const std::uint32_t node : fleet.node) fetch(node);
        }
}

template <Counter C>
inline void Bsp::count_steps(const Fleet& fleet, C& count) const {
    for (const std::uint32_t node : fleet.node) count(Event::step, !tree_.nodes[node].is_leaf());
}

/// Lanes that have just come to a leaf pass it where it is empty; else they wait for each other.
template <Query Q, Counter C>
inline void Bsp::visit_leaves(Fleet& fleet, FleetLanes lanes, FleetLanes& over, C& count) const {
    simd::for_each(lanes, [&](std::size_t lane) {
        const BspNode leaf = tree_.nodes[fleet.node[lane]];
        count(Event::cell);
        if (leaf.is_empty()) {
            count(Event::empty_cell);
            over |= static_cast<FleetLanes>(!fleet.pop(lane)) << lane;
            return;
        }
        const PackedLeaf packed = leaf.leaf();
        fetch(packed);
        fleet.passengers[lane].next_block = packed.first_block();
        fleet.passengers[lane].end_block = packed.first_block() + packed.block_count();
        const FleetLanes triangles = packed.only_triangles(), mixed = packed.is_mixed();
        fleet.to_triangles |= triangles << lane;
        fleet.to_mixed |= mixed << lane;
        fleet.to_spheres |= (1 ^ triangles ^ mixed) << lane;
        fleet.waiting |= 1u << lane;
    });
}

/// After a leaf has been tested.
template <Query Q>
inline void Bsp::leave(Fleet& fleet, std::size_t lane, FleetLanes& over) const {
    fleet.waiting &= ~(1u << lane);
    const bool hit = Q == Query::occluded && fleet.passengers[lane].hit.primitive != no_primitive;
    const bool goes_on = fleet.pop(lane);
    over |= static_cast<FleetLanes>(hit | !goes_on) << lane;
}

/// Blocks for as many lanes at once as there are; fewer only where most lanes wait.
template <Query Q, class Block, Counter C>
inline void Bsp::visit_blocks(Fleet& fleet, FleetLanes& at_block, FleetLanes& over,
                              C& count) const {
    const auto worth_while = [&] {
        const int waiting = std::popcount(at_block);
        return waiting >= static_cast<int>(rays_by_blocks) ||
               (waiting > 0 && (fleet.waiting | fleet.idle) == Fleet::all);
    };
    while (worth_while()) {
        RaysAndBlocks<Block> pairs;
        std::array<std::size_t, rays_by_blocks> numbers;
        std::size_t together = 0;
        for (; together < rays_by_blocks && at_block != 0; ++together) {
            numbers[together] = static_cast<std::size_t>(std::countr_zero(at_block));
            at_block &= at_block - 1;
            Fleet::Passenger& passenger = fleet.passengers[numbers[together]];
            pairs[together] = {&passenger.ray, &passenger.hit,
                               &tree_.leaves.block<Block>(passenger.next_block)};
        }
        const float padding = tree_.leaves.padding();
        constexpr Misses misses = Q == Query::closest ? Misses::go_on : Misses::leave;
        if constexpr (std::is_same_v<Block, SphereBlock>)
            test<misses>(pairs, together, padding, count);
        else if (tree_.leaves.precision() == Precision::standard)
            test<Precision::standard, misses, Q>(pairs, together, padding, count);
        else test<Precision::watertight, misses, Q>(pairs, together, padding, count);
        for (std::size_t i = 0; i < together; ++i) {
            Fleet::Passenger& passenger = fleet.passengers[numbers[i]];
            const bool hit = Q == Query::occluded && passenger.hit.primitive != no_primitive;
            if (++passenger.next_block < passenger.end_block && !hit) at_block |= 1u << numbers[i];
            else leave<Q>(fleet, numbers[i], over);
        }
    }
}

template <Query Q, Counter C>
inline void Bsp::visit_mixed(Fleet& fleet, FleetLanes& over, C& count) const {
    simd::for_each(std::exchange(fleet.to_mixed, 0), [&](std::size_t lane) {
        Fleet::Passenger& passenger = fleet.passengers[lane];
        const PackedLeaf leaf = tree_.nodes[fleet.node[lane]].leaf();
        tree_.leaves.template test<Q>(leaf, passenger.ray, passenger.hit, count);
        leave<Q>(fleet, lane, over);
    });
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
