#pragma once

#include "accel/octree/lists.h"

/// The cells of an octree as nodes.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The eight children of a node follow each other.
class OctreeNodes {
public:
    using Cell = std::uint32_t;

    OctreeNodes() = default;
    /// Hands the members of the leaves over to `lists`.
    OctreeNodes(OctreeCell& root, OctreeLists& lists);

    static Cell root() { return 0; }
    bool interior(Cell cell) const { return (nodes_[cell].next & leaf_bit) == 0; }
    float plane(Cell cell, int axis) const {
        return nodes_[cell].planes[static_cast<std::size_t>(axis)];
    }
    Cell child(Cell cell, unsigned i) const { return nodes_[cell].next + i; }
    std::uint32_t leaf(Cell cell) const { return nodes_[cell].next & ~leaf_bit; }

    std::size_t bytes() const { return nodes_.size() * sizeof(Node); }

private:
    static constexpr std::uint32_t leaf_bit = 0x80000000;
    struct Node {
        std::array<float, 3> planes{};
        std::uint32_t next = leaf_bit | empty_leaf;  ///< the first child; of a leaf: its number
    };
    static_assert(sizeof(Node) == 16);

    void add(std::size_t place, OctreeCell& cell, OctreeLists& lists);

    PagedVector<Node> nodes_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
