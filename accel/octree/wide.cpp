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
    Layout(const Geometry& geometry, const Membership& membership)
        : geometry_(geometry),
          outlined_(membership.overlap() == Overlap::exact),
          packer_(geometry) {}

    WideOctree build(OctreeCell& root) && {
        const std::uint32_t first = next_node();
        if (root.interior()) {
            add(first, root);
        } else if (!root.members.empty()) {
            Siblings only;
            only.add(root.box, leaf(first, root));
            nodes_[first] = WideNode8(only);
        }
        RawArray<WideNode8> nodes(nodes_.size());
        std::uninitialized_copy(nodes_.begin(), nodes_.end(), nodes.data());
        WideOctree octree{{std::move(nodes), std::move(packer_).build(), leaves_, depth_}, {}};
        if (outlined_)
            octree.outlines = OutlinedRuns(
                held_.size(), [&](std::size_t node) { return held_[node].references; },
                [&](std::size_t node) { return held_[node].bounds; });
        return octree;
    }

private:
    /// By the leaves among a node's children.
    struct Held {
        Box bounds;
        std::uint64_t references = 0;
    };

    std::uint32_t next_node() {
        if (nodes_.size() == WideChild::most_nodes)
            throw std::length_error("more than 2^31 - 1 nodes");
        nodes_.emplace_back();
        if (outlined_) held_.emplace_back();
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }
    /// Depth first.
    void add(std::uint32_t place, OctreeCell& cell) {
        Siblings siblings;
        for (OctreeCell* child : together(cell)) {
            if (!child->interior()) {
                siblings.add(child->box, leaf(place, *child));
                continue;
            }
            const std::uint32_t next = next_node();
            siblings.add(child->box, WideChild::node(next));
            add(next, *child);
        }
        nodes_[place] = WideNode8(siblings);
    }
    /// Of node `place`.
    WideChild leaf(std::uint32_t place, OctreeCell& cell) {
        ++leaves_;
        depth_ = std::max(depth_, cell.lattice.level);
        if (outlined_) {
            for (const std::uint32_t member : cell.members)
                held_[place].bounds.include(geometry_.bounds(member));
            held_[place].references += cell.members.size();
        }
        const PackedLeaf packed = packer_.add(cell.members);
        cell.members = {};
        return WideChild::leaf(packed);
    }

    const Geometry& geometry_;
    bool outlined_;
    LeafPacker packer_;
    PagedVector<WideNode8> nodes_;
    std::vector<Held> held_;  ///< by each node, if outlined
    std::uint32_t leaves_ = 0;
    int depth_ = 0;
};

}  // namespace

WideOctree wide_octree(const Geometry& geometry, OctreeCell& root, const Membership& membership,
                       bool loose) {
    shrink(root, membership, loose);
    return Layout(geometry, membership).build(root);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
