#include "accel/bsp/ropes.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

class Roper {
public:
    explicit Roper(BspTree& tree) : tree_(tree) {}

    std::vector<RopedLeaf> leaves(const Box& space) && {
        RopedLeaf root{space, {}};
        root.ropes.fill(RopedLeaf::outside);
        rope(0, root);
        return std::move(leaves_);
    }

private:
    /// Gives the ropes of a cell to its leaves.
    void rope(std::uint32_t number, const RopedLeaf& cell) {
        const BspNode node = tree_.nodes[number];
        if (node.is_leaf()) {
            tree_.nodes[number] = node.numbered(static_cast<std::uint32_t>(leaves_.size()));
            leaves_.push_back(cell);
            for (std::size_t face = 0; face < 6; ++face) tighten(leaves_.back(), face);
            return;
        }
        const std::size_t axis = node.axis();
        RopedLeaf left = cell, right = cell;
        left.box.hi[static_cast<int>(axis)] = right.box.lo[static_cast<int>(axis)] = node.plane();
        left.ropes[axis + 3] = node.children() + 1;
        right.ropes[axis] = node.children();
        rope(node.children(), left);
        rope(node.children() + 1, right);
    }

    /// As far down as one child is behind the whole face.
    void tighten(RopedLeaf& leaf, std::size_t face) const {
        std::uint32_t& rope = leaf.ropes[face];
        if (rope == RopedLeaf::outside) return;
        for (BspNode node = tree_.nodes[rope]; !node.is_leaf(); node = tree_.nodes[rope]) {
            const int axis = static_cast<int>(node.axis());
            const bool across = node.axis() == face % 3;
            const bool below = across ? face < 3 : false;  // behind a lower face lie upper children
            if (across) rope = node.children() + below;
            else if (node.plane() >= leaf.box.hi[axis]) rope = node.children();
            else if (node.plane() <= leaf.box.lo[axis]) rope = node.children() + 1;
            else return;
        }
    }

    BspTree& tree_;
    std::vector<RopedLeaf> leaves_;
};

}  // namespace

std::vector<RopedLeaf> roped_leaves(BspTree& tree, const Box& space) {
    return Roper(tree).leaves(space);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
