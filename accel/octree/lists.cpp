#include "accel/octree/lists.h"

#include "accel/simd/leaf_packer.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {

std::uint32_t OctreeLists::add(OctreeCell& leaf) {
    if (leaf.members.empty()) return empty_leaf;
    if (members.size() + leaf.members.size() > 0xffffffff)
        throw std::length_error("more than 2^32 - 1 references of an octree");
    leaves.push_back({static_cast<std::uint32_t>(members.size()),
                      static_cast<std::uint32_t>(leaf.members.size())});
    members.insert(members.end(), leaf.members.begin(), leaf.members.end());
    leaf.members = {};
    return static_cast<std::uint32_t>(leaves.size() - 1);
}

Box OctreeLists::bounds(const Geometry& geometry, std::size_t leaf) const {
    Box box;
    for (std::uint32_t i = 0; i < leaves[leaf].count; ++i)
        box.include(geometry.bounds(members[leaves[leaf].first + i]));
    return box;
}

OctreeLeaves::OctreeLeaves(const Geometry& geometry, OctreeLists&& lists, OctreeLeafTest test)
    : test_(test) {
    if (test == OctreeLeafTest::single) {
        scalar_ = Leaves(geometry, lists.members, lists.leaves);
        ranges_ = std::move(lists.leaves);
        return;
    }
    LeafPacker packer(geometry);
    words_.reserve(lists.leaves.size());
    for (const LeafRange& leaf : lists.leaves)
        words_.push_back(packer.add(std::span(lists.members).subspan(leaf.first, leaf.count)));
    packed_ = std::move(packer).build();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
