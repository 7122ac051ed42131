#pragma once

#include "accel/bsp/kd_cell.h"
#include "accel/bsp/sketch.h"

/// A part of a kd-tree that one thread builds.
namespace rayshoot::inline RAYSHOOT_ISA {

/// References of cells that are still to be divided stand on two stacks, of left halves and of
/// right ones.
class KdSubTree {
public:
    KdSubTree(const KdParting& parting, BspSketch& sketch) : parting_(parting), sketch_(sketch) {}

    /// The sub-tree of a node of the sketch.
    void build(std::uint32_t node, const KdCell& cell, std::span<const Reference> references) {
        stacks_[0].clear();
        stacks_[1].assign(references.begin(), references.end());
        subdivide(node, cell, 1, 0);
    }

private:
    void subdivide(std::uint32_t node, const KdCell& cell, std::size_t stack, std::size_t first);
    void make_leaf(std::uint32_t node, std::span<const Reference> references);

    const KdParting& parting_;
    BspSketch& sketch_;
    std::array<References, 2> stacks_;
    std::vector<std::uint32_t> numbers_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
