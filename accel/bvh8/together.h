#pragma once

#include "accel/bvh8/bvh8.h"

/// A packet goes through the tree as one beam (Reshetov, Soupikov & Hurley 2005); only leaves tell
/// its rays apart. A beam that meets many nodes is wider than what it sees is large: then each
/// group of the packet goes on from where it came to, and knows of each child which of its rays
/// enter it.
namespace rayshoot::inline RAYSHOOT_ISA {

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::trace_together(const Part& part, Answers<Q>& answers, Scratch& scratch,
                                          Company& company, C& count) const {
    Packet& packet = scratch.packet;
    if (!follow<Q>(packet, scratch.halts, count))
        for (std::size_t group = 0; group < packet.groups(); ++group) {
            set_out(packet, group, scratch, count);
            follow<Q>(packet, group, scratch.walk, company, count);
        }
    for (std::size_t i = 0; i < part.rays.size(); ++i) answers.store(part.first + i, packet.hit(i));
}

/// Whether the beam of the whole packet came to the end of its halts in so few steps.
template <class Node>
template <Query Q, Counter C>
inline bool WideBvh<Node>::follow(Packet& packet, Halts& halts, C& count) const {
    Beam beam = packet.beam(packet.all());
    const auto enter = [&](std::uint32_t number) {
        const auto [met, entries] = step(beam, nodes_[number], count);
        halts.push(number, met, entries);
        if (halts.size() < 2) return;
        const Halt then = halts[halts.size() - 2];
        fetch(nodes_[then.node].child(then.place));
    };
    halts.clear();
    enter(0);
    for (int steps_left = wide_steps; !halts.empty();) {
        const Halt halt = halts.top();
        const Node& parent = nodes_[halt.node];
        const WideChild child = parent.child(halt.place);
        const bool reached = halt.entry <= beam.nearest;
        if (reached && child.interior() && steps_left-- == 0) return false;
        halts.drop();
        if (!reached) continue;
        if (child.interior()) {
            enter(child.number());
            continue;
        }
        RaySet rays = 0;
        for (std::size_t group = 0; group < packet.groups(); ++group) {
            if constexpr (C::counts) count(Event::bounding_volume_test, Packet::group);
            rays |= packet.enter(group, parent.bounds, halt.place) << group * Packet::group;
        }
        rayshoot::visit_leaf<Q>(leaves_, packet, rays, child.leaf(), count);
        beam.nearest = packet.reach(packet.all());
    }
    return true;
}

/// What the packet's beam has still to visit, by the rays of one group.
template <class Node>
template <Counter C>
inline void WideBvh<Node>::set_out(const Packet& packet, std::size_t group, Scratch& scratch,
                                   C& count) const {
    scratch.walk.clear();
    for (std::size_t i = 0; i < scratch.halts.size(); ++i) {
        const auto [node, place, entry] = scratch.halts[i];
        admit(packet, group, Packet::everyone, nodes_[node], place, entry, scratch.walk, count);
    }
}

/// To the end of the walk.
template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::follow(Packet& packet, std::size_t group, GroupWalk& walk,
                                  Company& company, C& count) const {
    const Packet::Section section = Packet::one(group);
    Beam beam = packet.beam(section);
    while (!walk.empty()) {
        const GroupHalt halt = walk.pop();
        if (halt.entry > beam.nearest) continue;
        if (!halt.child.interior()) {
            rayshoot::visit_leaf<Q>(leaves_, packet, halt.rays << group * Packet::group,
                                    halt.child.leaf(), count);
            beam.nearest = packet.reach(section);
            continue;
        }
        company.note(halt.rays);
        const Node& node = node_at(halt.child);
        const auto [met, entries] = step(beam, node, count);
        alignas(32) std::array<float, Node::width> entry_of;
        simd::hn::Store(entries, simd::floats<Node::width>, entry_of.data());
        const std::uint32_t nearest = nearest_of(met, entries);
        const std::uint32_t places = simd::bits(simd::floats<Node::width>, met);
        const auto enter = [&](std::size_t place) {
            admit(packet, group, halt.rays, node, place, entry_of[place], walk, count);
        };
        simd::for_each(places & ~(1u << nearest), enter);
        simd::for_each(places & 1u << nearest, enter);
    }
}

/// The rays of a group, among some, that enter a child are to visit it.
template <class Node>
template <Counter C>
inline void WideBvh<Node>::admit(const Packet& packet, std::size_t group, RaySet among,
                                 const Node& parent, std::size_t place, float entry,
                                 GroupWalk& walk, C& count) const {
    if constexpr (C::counts)
        count(Event::bounding_volume_test, static_cast<std::uint64_t>(std::popcount(among)));
    const WideChild child = parent.child(place);
    fetch(child);
    walk.admit(child, among & packet.enter(group, parent.bounds, place), entry);
}

/// The children that a beam meets, and where.
template <class Node>
template <Counter C>
inline std::pair<Places<Node::width>, simd::Floats<Node::width>> WideBvh<Node>::step(
    const Beam& beam, const Node& node, C& count) const {
    count(Event::step);
    if constexpr (C::counts) count(Event::bounding_volume_test, node.live());
    const auto [entry, exit] = beam.clip(node.bounds);
    return {simd::hn::Le(entry, exit), entry};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
