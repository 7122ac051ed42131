#pragma once

#include "accel/simd/packed_leaves.h"
#include "accel/simd/packet.h"

/// Some rays of a packet at a leaf.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Precision P, Counter C>
inline void visit_triangles(const PackedLeaves& leaves, Packet& packet, RaySet rays,
                            PackedLeaf leaf, C& count) {
    for (std::uint32_t i = 0; i < leaf.block_count(); ++i)
        packet.test<Q, P>(rays, leaves.block<TriangleBlock>(leaf.first_block() + i),
                          leaves.padding(), count);
}

/// Whatever is not triangles in the standard precision; out of the way of those that are.
template <Query Q, Counter C>
[[gnu::noinline]] void visit_others(const PackedLeaves& leaves, Packet& packet, RaySet rays,
                                    PackedLeaf leaf, C& count) {
    if (leaf.is_mixed())
        return packet.test_each<Q>(rays, [&](const TestRay& ray, Hit& hit) {
            leaves.template test<Q>(leaf, ray, hit, count);
        });
    if (leaf.only_triangles())
        return visit_triangles<Q, Precision::watertight>(leaves, packet, rays, leaf, count);
    for (std::uint32_t i = 0; i < leaf.block_count(); ++i)
        packet.test<Q>(rays, leaves.block<SphereBlock>(leaf.first_block() + i), leaves.padding(),
                       count);
}

template <Query Q, Counter C>
inline void visit_leaf(const PackedLeaves& leaves, Packet& packet, RaySet rays, PackedLeaf leaf,
                       C& count) {
    if constexpr (C::counts) count(Event::cell, static_cast<std::uint64_t>(std::popcount(rays)));
    if (leaf.only_triangles() && leaves.precision() == Precision::standard) [[likely]]
        visit_triangles<Q, Precision::standard>(leaves, packet, rays, leaf, count);
    else visit_others<Q>(leaves, packet, rays, leaf, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
