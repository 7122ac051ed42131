#include "accel/octree/linear_octree.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {

LinearOctree::LinearOctree(OctreeCell& root, OctreeLists& lists) : lattice_(root.box) {
    add(root, 0, lists);
}

void LinearOctree::add(OctreeCell& cell, std::uint64_t prefix, OctreeLists& lists) {
    const int below = bits - 1 - 3 * cell.lattice.level;  // bits for what lies deeper
    if (cell.interior()) {
        for (std::size_t i = 0; i < 8; ++i)
            add((*cell.children)[i], prefix | std::uint64_t{i} << (below - 2), lists);
    } else if (lists.add(cell) != empty_leaf) {
        codes_.push_back(prefix | std::uint64_t{1} << below);
    }
}

/// The leaves whose codes begin with the child's.
LinearOctree::Cell LinearOctree::child(const Cell& cell, unsigned i) const {
    const auto place_of = [&](std::uint64_t code) {
        return static_cast<unsigned>(code >> (bits - 3 - 3 * cell.lattice.level)) & 7;
    };
    const auto begin = codes_.begin() + cell.first, end = begin + cell.count;
    const auto first =
        std::partition_point(begin, end, [&](auto code) { return place_of(code) < i; });
    const auto last =
        std::partition_point(first, end, [&](auto code) { return place_of(code) == i; });
    return {static_cast<std::uint32_t>(first - codes_.begin()),
            static_cast<std::uint32_t>(last - first), cell.lattice.child(i)};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
