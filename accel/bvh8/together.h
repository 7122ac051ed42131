#pragma once

#include "accel/bvh8/bvh8.h"

/// A packet goes through the tree as one beam (Reshetov, Soupikov & Hurley 2005); only leaves tell
/// its rays apart. A beam that meets many nodes is wider than what it sees is large: then sections
/// of the packet go on from where it came to as narrower beams, and at last each ray alone.
namespace rayshoot::inline RAYSHOOT_ISA {

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::trace_together(const Part& part, Answers<Q>& answers, Scratch& scratch,
                                          C& count) const {
    constexpr std::size_t narrow = std::max<std::size_t>(1, 16 / Packet::group);  // groups
    Packet& packet = scratch.packet;
    Halts& halts = scratch.halts;
    const auto store = [&](Packet::Section section) {
        for (std::size_t i = section.first_ray(); i < section.end_ray(); ++i)
            answers.store(part.first + i, packet.hit(i));
    };
    const Packet::Section all = packet.all();
    halts.clear();
    step(packet.beam(all), 0, halts, count);
    if (follow<Q>(packet, all, wide_steps, halts, count)) return store(all);
    halts.set_aside();
    for (std::size_t first = 0; first < all.count; first += narrow) {
        const Packet::Section section{first, std::min(narrow, all.count - first)};
        halts.repeat();
        if (follow<Q>(packet, section, narrow_steps, halts, count)) {
            store(section);
        } else {
            const std::span<const Ray> rays =
                part.rays.subspan(section.first_ray(), section.end_ray() - section.first_ray());
            trace_each<Q>(
                {rays, part.first + section.first_ray(), &packet, section.first_ray(), &halts},
                answers, scratch, count);
        }
    }
}

/// Whether the beam came to the end of its halts in so many steps.
template <class Node>
template <Query Q, Counter C>
inline bool WideBvh<Node>::follow(Packet& packet, Packet::Section section, int most_steps,
                                  Halts& halts, C& count) const {
    Beam beam = packet.beam(section);
    while (!halts.empty()) {
        const Halt halt = halts.top();
        if (halt.entry > beam.nearest) {
            halts.pop();
            continue;
        }
        const WideChild child = nodes_[halt.node].child(halt.place);
        if (!child.interior()) {
            halts.pop();
            visit_leaf<Q>(packet, section, halt, count);
            beam.nearest = packet.reach(section);
        } else if (most_steps-- > 0) {
            halts.pop();
            step(beam, child.number(), halts, count);
        } else {
            return false;
        }
    }
    return true;
}

/// The children that the beam meets become halts.
template <class Node>
template <Counter C>
inline void WideBvh<Node>::step(const Beam& beam, std::uint32_t number, Halts& halts,
                                C& count) const {
    const Node& node = nodes_[number];
    count(Event::step);
    if constexpr (C::counts) count(Event::bounding_volume_test, node.live());
    const auto [entry, exit] = beam.clip(node.bounds);
    halts.push(number, simd::hn::Le(entry, exit), entry);
    if (halts.size() > 1) {
        const Halt then = halts[halts.size() - 2];
        fetch(nodes_[then.node].child(then.place));
    }
}

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::visit_leaf(Packet& packet, Packet::Section section, const Halt& halt,
                                      C& count) const {
    using namespace simd;
    const Node& parent = nodes_[halt.node];
    const PackedLeaf leaf = parent.child(halt.place).leaf();
    for (std::size_t group = section.first; group < section.end(); ++group) {
        const Packet::Mask active = packet.meets(group, parent.bounds, halt.place);
        if constexpr (C::counts) {
            count(Event::bounding_volume_test, Packet::group);
            count(Event::cell, hn::CountTrue(floats<Packet::group>, active));
        }
        if (hn::AllFalse(floats<Packet::group>, active)) continue;
        if (leaf.only_triangles() && leaves_.precision() == Precision::standard) [[likely]]
            test_triangles<Q, Precision::standard>(packet, group, active, leaf, count);
        else test_others<Q>(packet, group, active, leaf, count);
    }
}

template <class Node>
template <Query Q, Precision P, Counter C>
inline void WideBvh<Node>::test_triangles(Packet& packet, std::size_t group, Packet::Mask active,
                                          PackedLeaf leaf, C& count) const {
    for (std::uint32_t i = 0; i < leaf.block_count(); ++i)
        packet.test<Q, P>(group, active, leaves_.block<TriangleBlock>(leaf.first_block() + i),
                          leaves_.padding(), count);
}

template <class Node>
template <Query Q, Counter C>
void WideBvh<Node>::test_others(Packet& packet, std::size_t group, Packet::Mask active,
                                PackedLeaf leaf, C& count) const {
    if (leaf.is_mixed())
        return packet.test_each<Q>(group, active, [&](const TestRay& ray, Hit& hit) {
            leaves_.template test<Q>(leaf, ray, hit, count);
        });
    if (leaf.only_triangles())
        return test_triangles<Q, Precision::watertight>(packet, group, active, leaf, count);
    for (std::uint32_t i = 0; i < leaf.block_count(); ++i)
        packet.test<Q>(group, active, leaves_.block<SphereBlock>(leaf.first_block() + i),
                       leaves_.padding(), count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
