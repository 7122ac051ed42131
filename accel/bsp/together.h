#pragma once

#include "accel/bsp/bsp.h"

/// A packet goes through the tree once; each of its rays has its own part of every cell (Wald,
/// Slusallek, Benthin & Wagner 2001).
namespace rayshoot::inline RAYSHOOT_ISA {

/// Registers of rays, one after the other.
class PacketLanes {
public:
    static constexpr std::size_t lanes = Packet::lanes, registers = Packet::most / lanes;
    static constexpr auto tag = simd::floats<lanes>;
    using V = Packet::V;
    using Row = BspPacketHalt::Rows;

    static V load(const Row& row, std::size_t i) { return simd::hn::Load(tag, &row[i * lanes]); }
    static void store(V v, Row& row, std::size_t i) { simd::hn::Store(v, tag, &row[i * lanes]); }
    /// Calls visit(i) for the registers that hold any of the rays.
    template <class Visit>
    static void each(RaySet rays, Visit&& visit) {
        constexpr RaySet one = (RaySet{1} << lanes) - 1;
        for (std::size_t i = 0; i < registers; ++i)
            if ((rays >> i * lanes & one) != 0) visit(i);
    }
    template <class Mask>
    static RaySet bits(Mask mask, std::size_t i) {
        return RaySet{simd::bits(tag, mask)} << i * lanes;
    }
};

/// Where all rays enter and leave the whole.
inline void enter(const Packet& packet, const Box& space, BspPacketHalt& root) {
    using L = PacketLanes;
    using namespace simd;
    root.rays = 0;
    root.node = 0;
    for (std::size_t i = 0; i * L::lanes < packet.all().end; ++i) {
        const std::size_t first = i * L::lanes;
        auto entry = packet.t_min(first), exit = packet.nearest(first);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int a = static_cast<int>(axis);
            const bool descending = packet.descending(axis);
            const auto at = [&](float plane) {
                return hn::Mul(hn::Sub(hn::Set(L::tag, plane), packet.origin(axis, first)),
                               packet.inverse(axis, first));
            };
            entry = larger(at(descending ? space.hi[a] : space.lo[a]), entry);
            exit = smaller(at(descending ? space.lo[a] : space.hi[a]), exit);
        }
        L::store(entry, root.entry, i);
        L::store(exit, root.exit, i);
        root.rays |= L::bits(hn::Le(entry, exit), i);
    }
}

/// Drops the rays whose hits lie before the cell; false where none is left.
inline bool still_reached(const Packet& packet, BspPacketHalt& halt) {
    using L = PacketLanes;
    using namespace simd;
    RaySet reached = 0;
    L::each(halt.rays, [&](std::size_t i) {
        const auto nearest = packet.nearest(i * L::lanes);
        reached |= L::bits(hn::Le(L::load(halt.entry, i), nearest), i);
        L::store(smaller(nearest, L::load(halt.exit, i)), halt.exit, i);
    });
    halt.rays &= reached;
    return halt.rays != 0;
}

/// One step: `here` goes on to the near child, if any ray meets it; `later` is the far one then, or
/// no ray's.
inline void cross(const Packet& packet, BspNode node, BspPacketHalt& here, BspPacketHalt& later) {
    using L = PacketLanes;
    using namespace simd;
    const std::size_t axis = node.axis();
    const auto plane = hn::Set(L::tag, node.plane());
    std::array<L::V, L::registers> t;
    RaySet not_near = 0, not_far = 0;
    L::each(here.rays, [&](std::size_t i) {
        const std::size_t first = i * L::lanes;
        t[i] = hn::Mul(hn::Sub(plane, packet.origin(axis, first)), packet.inverse(axis, first));
        not_near |= L::bits(hn::Lt(t[i], L::load(here.entry, i)), i);
        not_far |= L::bits(hn::Gt(t[i], L::load(here.exit, i)), i);
    });
    const std::uint32_t side = packet.descending(axis), near = node.children() + side,
                        far = near ^ 1;
    const RaySet to_near = here.rays & ~not_near, to_far = here.rays & ~not_far;
    later.rays = 0;
    here.node = to_near != 0 ? near : far;
    if (to_near == 0 || to_far == 0) return;
    // Empty leaves are not visited.
    if (node.empty_child(side)) {
        L::each(here.rays, [&](std::size_t i) {
            L::store(larger(t[i], L::load(here.entry, i)), here.entry, i);
        });
        here.rays = to_far;
        here.node = far;
        return;
    }
    L::each(here.rays, [&](std::size_t i) {
        L::store(larger(t[i], L::load(here.entry, i)), later.entry, i);
        L::store(L::load(here.exit, i), later.exit, i);
        L::store(smaller(t[i], L::load(here.exit, i)), here.exit, i);
    });
    here.rays = to_near;
    later.rays = node.empty_child(side ^ 1) ? 0 : to_far;
    later.node = far;
}

template <Query Q, Counter C>
inline void Bsp::visit_leaf(Packet& packet, RaySet rays, BspNode leaf, C& count) const {
    if (!leaf.is_empty())
        return rayshoot::visit_leaf<Q>(tree_.leaves, packet, rays, leaf.leaf(), count);
    if constexpr (C::counts) {
        const auto visits = static_cast<std::uint64_t>(std::popcount(rays));
        count(Event::cell, visits);
        count(Event::empty_cell, visits);
    }
}

template <Query Q, Counter C>
inline void Bsp::trace_together(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                                C& count) const {
    Packet& packet = scratch.packet;
    BspPacketHalt& here = scratch.walk.here;
    BspPacketHalt* later = scratch.walk.later.data();
    const BspPacketHalt* const none = later;
    enter(packet, space_, here);
    while (true) {
        if (still_reached(packet, here)) {
            BspNode node = tree_.nodes[here.node];
            for (; !node.is_leaf(); node = tree_.nodes[here.node]) {
                count(Event::step);
                cross(packet, node, here, *later);
                if (later->rays == 0) continue;
                fetch_beyond(later->node);
                ++later;
            }
            visit_leaf<Q>(packet, here.rays, node, count);
        }
        if (later == none) break;
        here = *--later;
    }
    for (std::size_t i = 0; i < part.rays.size(); ++i) answers.store(part.first + i, packet.hit(i));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
