#include "accel/octree/nodes.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {

OctreeNodes::OctreeNodes(OctreeCell& root, OctreeLists& lists) {
    nodes_.emplace_back();
    add(0, root, lists);
}

void OctreeNodes::add(std::size_t place, OctreeCell& cell, OctreeLists& lists) {
    if (!cell.interior()) {
        nodes_[place].next = leaf_bit | lists.add(cell);
        return;
    }
    const std::size_t first = nodes_.size();
    if (first + 8 >= leaf_bit) throw std::length_error("more than 2^31 - 1 nodes of an octree");
    nodes_[place] = {cell.planes, static_cast<std::uint32_t>(first)};
    nodes_.resize(first + 8);
    for (std::size_t i = 0; i < 8; ++i) add(first + i, (*cell.children)[i], lists);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
