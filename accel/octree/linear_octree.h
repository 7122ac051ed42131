#pragma once

#include "accel/octree/lists.h"

/// The linear octree of Gargantini 1982: no nodes, only a sorted list of the leaves that are not
/// empty.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Each leaf by its locational code: the places of its ancestors and its own among their siblings,
/// three bits each, from the highest down, then a one that says where they end. So codes ascend
/// in depth-first order, and the leaves of any cell follow each other.
class LinearOctree {
public:
    /// The leaves that a cell holds, as seen on the way down to them.
    struct Cell {
        std::uint32_t first, count;
        OctreePlace lattice;
    };

    LinearOctree() = default;
    /// Hands the members of the leaves over to `lists`. All cuts are in the middle.
    LinearOctree(OctreeCell& root, OctreeLists& lists);

    Cell root() const { return {0, static_cast<std::uint32_t>(codes_.size()), {}}; }
    bool interior(const Cell& cell) const {
        return cell.count > 1 ||
               (cell.count == 1 && level(codes_[cell.first]) > cell.lattice.level);
    }
    float plane(const Cell& cell, int axis) const { return lattice_.middle(axis, cell.lattice); }
    Cell child(const Cell& cell, unsigned i) const;
    std::uint32_t leaf(const Cell& cell) const { return cell.count == 0 ? empty_leaf : cell.first; }

    std::size_t bytes() const { return codes_.size() * sizeof(std::uint64_t); }

private:
    static constexpr int bits = 3 * OctreeLattice::most_levels + 1;
    static int level(std::uint64_t code) { return (bits - 1 - std::countr_zero(code)) / 3; }
    void add(OctreeCell& cell, std::uint64_t prefix, OctreeLists& lists);

    OctreeLattice lattice_;
    PagedVector<std::uint64_t> codes_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
