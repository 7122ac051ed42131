#include "accel/bsp/layout.h"

#include "accel/simd/leaf_packer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

using Kind = BspSketch::Kind;

std::uint32_t blocks_of(std::uint32_t members) {
    constexpr auto width = static_cast<std::uint32_t>(TriangleBlock::width);
    return (members + width - 1) / width;
}

/// A part of the tree, and where it is to stand.
struct Piece {
    const BspSketch* sketch;
    std::uint64_t pairs = 0, leaves = 0, empty_leaves = 0, blocks = 0;
    std::uint32_t largest_leaf = 0;
    std::uint32_t root = 0;                         ///< node
    std::uint64_t first_pair = 0, first_block = 0;  ///< of its own
    std::size_t first_part = 0;                     ///< piece
    std::uint32_t first_plane = 0;                  ///< of its own

    void measure() {
        for (const BspSketch::Node& node : sketch->nodes) {
            pairs += node.kind == Kind::interior;
            if (node.kind != Kind::leaf) continue;
            ++leaves;
            empty_leaves += node.count == 0;
            blocks += blocks_of(node.count);
            largest_leaf = std::max(largest_leaf, node.count);
        }
    }
};

class Layout {
public:
    Layout(const Geometry& geometry, const BspSketch& sketch) : packer_(geometry) {
        collect(sketch);
        tbb::parallel_for(std::size_t{0}, pieces_.size(),
                          [&](std::size_t i) { pieces_[i].measure(); });
        place();
        std::uint32_t largest_leaf = 0;
        for (const Piece& piece : pieces_)
            largest_leaf = std::max(largest_leaf, piece.largest_leaf);
        parallel_ = blocks_of(largest_leaf) <= PackedLeaf::most_blocks &&
                    packer_.make_room_for_triangles(blocks_);
    }

    BspTree build() && {
        nodes_ = RawArray<BspNode>(2 * pairs_);
        nodes_[1] = BspNode::empty_leaf();
        // Where a part's root stands is known when the part above it is filled.
        for (const Piece& piece : pieces_)
            if (!piece.sketch->parts.empty() || !parallel_) fill(piece);
        if (parallel_)
            tbb::parallel_for(std::size_t{0}, pieces_.size(), [&](std::size_t i) {
                if (pieces_[i].sketch->parts.empty()) fill(pieces_[i]);
            });
        BspTree tree{std::move(nodes_), std::move(packer_).build(), footprint_, std::move(planes_)};
        tree.footprint.bytes = tree.nodes.size() * sizeof(BspNode) + tree.leaves.bytes() +
                               tree.planes.size() * sizeof(ObliquePlane);
        return tree;
    }

private:
    /// Each before its parts.
    void collect(const BspSketch& sketch) {
        pieces_.push_back({&sketch});
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            pieces_[i].first_part = pieces_.size();
            const auto& parts = pieces_[i].sketch->parts;
            for (const auto& part : parts) pieces_.push_back({part.get()});
        }
    }

    void place() {
        std::uint64_t interior = 0, leaves = 0, empty = 0, references = 0, depth = 0;
        bool bounded = false;
        for (Piece& piece : pieces_) {
            piece.first_pair = pairs_;
            piece.first_block = blocks_;
            piece.first_plane = static_cast<std::uint32_t>(planes_.size());
            planes_.insert(planes_.end(), piece.sketch->planes.begin(), piece.sketch->planes.end());
            pairs_ += piece.pairs;
            blocks_ += piece.blocks;
            interior += piece.pairs;
            leaves += piece.leaves;
            empty += piece.empty_leaves;
            references += piece.sketch->members.size();
            depth = std::max(depth, static_cast<std::uint64_t>(piece.sketch->depth));
            bounded |= piece.sketch->bounded;
        }
        if (pairs_ > BspNode::most_pairs) throw std::length_error("more than 2^27 pairs of nodes");
        footprint_ = {.interior = interior,
                      .leaves = leaves,
                      .empty_leaves = empty,
                      .references = references,
                      .depth = depth};
        if (bounded)
            footprint_.remark = "nodes were left undivided to keep to the bound on references";
    }

    /// Depth first, left before right, by threes: beside the children of a node lie theirs, so that
    /// a cache line is good for two steps.
    void fill(const Piece& piece) {
        Filling filling{*this,
                        piece,
                        static_cast<std::uint32_t>(piece.first_pair),
                        static_cast<std::uint32_t>(piece.first_block),
                        {}};
        filling.pending.push_back({0, piece.root});
        while (!filling.pending.empty()) {
            const auto [from, to] = filling.pending.back();
            filling.pending.pop_back();
            const auto children = filling.set(from, to);
            if (!children) continue;
            const auto left = filling.set(children->from, children->to);
            const auto right = filling.set(children->from + 1, children->to + 1);
            for (const auto& grandchildren : {right, left}) {
                if (!grandchildren) continue;
                const auto [first_from, first_to] = *grandchildren;
                filling.pending.push_back({first_from + 1, first_to + 1});
                filling.pending.push_back({first_from, first_to});
            }
        }
    }

    /// Nodes of the sketch on their way to nodes of the tree.
    struct Move {
        std::uint32_t from, to;
    };
    struct Filling {
        Layout& layout;
        const Piece& piece;
        std::uint32_t pair, block;  ///< the next ones
        std::vector<Move> pending;

        /// Returns where its left child goes, if it has any.
        std::optional<Move> set(std::uint32_t from, std::uint32_t to) {
            const BspSketch& sketch = *piece.sketch;
            const BspSketch::Node& node = sketch.nodes[from];
            if (node.kind == Kind::part) {
                layout.pieces_[piece.first_part + node.first].root = to;
                return {};
            }
            if (node.kind == Kind::leaf) {
                layout.nodes_[to] = layout.packed(sketch.members_of(node), block);
                block += blocks_of(node.count);
                return {};
            }
            const std::uint32_t empty = sketch.empty(node.first) | sketch.empty(node.first + 1)
                                                                       << 1;
            const BspNode laid_out = BspNode::interior(node.axis, node.plane, pair, empty);
            layout.nodes_[to] = node.axis == oblique_axis
                                    ? laid_out.numbered(piece.first_plane + laid_out.number())
                                    : laid_out;
            return Move{node.first, 2 * pair++};
        }
    };

    BspNode packed(std::span<const std::uint32_t> members, std::uint32_t block) {
        if (members.empty()) return BspNode::empty_leaf();
        return BspNode::leaf(parallel_ ? packer_.set_triangles(block, members)
                                       : packer_.add(members));
    }

    LeafPacker packer_;
    std::vector<Piece> pieces_;
    std::uint64_t pairs_ = 1, blocks_ = 0;  ///< the first pair is the root's
    RawArray<BspNode> nodes_;
    std::vector<ObliquePlane> planes_;
    Footprint footprint_;
    bool parallel_ = false;
};

}  // namespace

BspTree laid_out(const Geometry& geometry, const BspSketch& sketch) {
    return Layout(geometry, sketch).build();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
