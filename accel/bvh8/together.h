#pragma once

#include "accel/bvh8/bvh8.h"

/// A packet goes through the tree as one beam (Reshetov, Soupikov & Hurley 2005); only leaves tell
/// its rays apart.
namespace rayshoot::inline RAYSHOOT_ISA {

/// False where the packet is given up, with the nearest hits so far in it: a beam that meets so
/// many nodes is wider than what it sees is large, and its rays do better alone.
template <Query Q, Counter C>
inline bool Bvh8::trace_packet(Packet& packet, std::vector<Halt>& halts, C& count) const {
    using namespace simd;
    constexpr auto tag = floats<WideNode::width>;
    constexpr int most_steps = 64;
    const auto nearest_last = [](const Halt& a, const Halt& b) { return a.entry > b.entry; };
    halts.clear();
    WideChild current = WideChild::node(0);
    for (int steps = 0; steps < most_steps; ++steps) {
        const WideNode& node = node_at(current);
        count(Event::step);
        if constexpr (C::counts) count(Event::bounding_volume_test, node.live);
        const auto [entry, exit] = packet.beam().clip(node.bounds);
        alignas(32) std::array<float, WideNode::width> entries;
        hn::Store(entry, tag, entries.data());
        const auto before = static_cast<std::ptrdiff_t>(halts.size());
        for (std::uint32_t rest = bits(tag, hn::Le(entry, exit)); rest != 0; rest &= rest - 1) {
            const auto place = static_cast<std::uint32_t>(std::countr_zero(rest));
            halts.push_back({current.bits(), place, entries[place]});
        }
        std::sort(halts.begin() + before, halts.end(), nearest_last);
        while (true) {
            if (halts.empty()) return true;
            const Halt next = halts.back();
            halts.pop_back();
            if (next.entry > packet.beam().nearest) continue;
            const WideNode& parent = node_at(WideChild::from(next.node));
            const WideChild child = parent.child(next.place);
            if (child.interior()) {
                current = child;
                break;
            }
            visit_leaf<Q>(packet, parent, next.place, count);
        }
    }
    return false;
}

template <Query Q, Counter C>
inline void Bvh8::visit_leaf(Packet& packet, const WideNode& parent, std::size_t place,
                             C& count) const {
    using namespace simd;
    const PackedLeaf leaf = parent.child(place).leaf();
    for (std::size_t group = 0; group < packet.groups(); ++group) {
        const Packet::Mask active = packet.meets(group, parent.bounds, place);
        if constexpr (C::counts) {
            count(Event::bounding_volume_test, Packet::group);
            count(Event::cell, hn::CountTrue(floats<Packet::group>, active));
        }
        if (hn::AllFalse(floats<Packet::group>, active)) continue;
        for (std::uint32_t i = 0; i < leaf.block_count(); ++i)
            packet.test<Q>(group, active, leaves_.triangles(leaf.first_block() + i),
                           leaves_.padding(), count);
    }
    packet.shorten();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
