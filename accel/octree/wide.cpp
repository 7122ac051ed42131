#include "accel/octree/wide.h"

#include "accel/simd/leaf_packer.h"

#include <tbb/parallel_for.h>

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr int parallel_levels = 3;

/// Makes each cell's box that of its contents, from the leaves up; without contents it is empty.
void shrink(OctreeCell& cell, const Membership& membership, bool loose) {
    const Box whole = cell.box;
    cell.box = {};
    if (!cell.interior()) {
        for (const std::uint32_t member : cell.members)
            cell.box.include(loose ? membership.box(member) : membership.clipped(member, whole));
        return;
    }
    const auto below = [&](std::size_t i) { shrink((*cell.children)[i], membership, loose); };
    if (cell.lattice.level < parallel_levels)
        tbb::parallel_for(std::size_t{0}, std::size_t{8}, below);
    else
        for (std::size_t i = 0; i < 8; ++i) below(i);
    for (const OctreeCell& child : *cell.children) cell.box.include(child.box);
}

using Cells = std::vector<OctreeCell*>;

void append_live(OctreeCell& cell, Cells& cells) {
    for (OctreeCell& child : *cell.children)
        if (!child.box.empty()) cells.push_back(&child);
}

/// The children of a cell that hold something; and as long as there is room in a node, instead of
/// the largest of them that fit, their own.
Cells together(OctreeCell& cell) {
    Cells cells;
    append_live(cell, cells);
    while (true) {
        std::size_t largest = cells.size();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (!cells[i]->interior()) continue;
            Cells below;
            append_live(*cells[i], below);
            if (cells.size() - 1 + below.size() > most_children) continue;
            const bool larger = largest == cells.size() ||
                                cells[i]->box.half_area() > cells[largest]->box.half_area();
            if (larger) largest = i;
        }
        if (largest == cells.size()) return cells;
        OctreeCell& opened = *cells[largest];
        cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(largest));
        append_live(opened, cells);
    }
}

class Layout {
public:
    explicit Layout(const Geometry& geometry) : packer_(geometry) {}

    WideTree<WideNode8> build(OctreeCell& root) && {
        nodes_.emplace_back();
        if (root.interior()) {
            add(0, root);
        } else if (!root.members.empty()) {
            Siblings only;
            only.add(root.box, leaf(root));
            nodes_[0] = WideNode8(only);
        }
        RawArray<WideNode8> nodes(nodes_.size());
        std::uninitialized_copy(nodes_.begin(), nodes_.end(), nodes.data());
        return {std::move(nodes), std::move(packer_).build(), leaves_, depth_};
    }

private:
    /// Depth first.
    void add(std::size_t place, OctreeCell& cell) {
        Siblings siblings;
        for (OctreeCell* child : together(cell)) {
            if (!child->interior()) {
                siblings.add(child->box, leaf(*child));
                continue;
            }
            const auto next = static_cast<std::uint32_t>(nodes_.size());
            if (next == WideChild::most_nodes) throw std::length_error("more than 2^31 - 1 nodes");
            siblings.add(child->box, WideChild::node(next));
            nodes_.emplace_back();
            add(next, *child);
        }
        nodes_[place] = WideNode8(siblings);
    }
    WideChild leaf(OctreeCell& cell) {
        ++leaves_;
        depth_ = std::max(depth_, cell.lattice.level);
        const PackedLeaf packed = packer_.add(cell.members);
        cell.members = {};
        return WideChild::leaf(packed);
    }

    LeafPacker packer_;
    PagedVector<WideNode8> nodes_;
    std::uint32_t leaves_ = 0;
    int depth_ = 0;
};

}  // namespace

WideTree<WideNode8> wide_octree(const Geometry& geometry, OctreeCell& root,
                                const Membership& membership, bool loose) {
    shrink(root, membership, loose);
    return Layout(geometry).build(root);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
