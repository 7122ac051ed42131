#include "accel/grid/cell_leaves.h"

#include "accel/simd/leaf_packer.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

std::span<std::uint32_t> members_of(GridTree& tree, const LeafRange& leaf) {
    return std::span(tree.members).subspan(leaf.first, leaf.count);
}

/// By kind, then motion, then number: as Leaves puts them.
void order_as_leaves(const Geometry& geometry, GridTree& tree) {
    const auto key = [&](std::uint32_t primitive) {
        const PrimitiveRef& ref = geometry.ref(primitive);
        return std::tuple(ref.motion, ref.kind, primitive);
    };
    tbb::parallel_for(std::size_t{0}, tree.leaves.size(), [&](std::size_t leaf) {
        const auto members = members_of(tree, tree.leaves[leaf]);
        std::sort(members.begin(), members.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    });
}

template <class Word>
void rename_leaves(GridTree& tree, const Word& word_of) {
    for (CellWord& word : tree.cells)
        if (word.is_leaf()) word = CellWord::leaf(word_of(word.leaf()));
}

}  // namespace

CellLeaves::CellLeaves(const Geometry& geometry, LeafKind kind, bool mailbox, GridTree& tree)
    : kind_(kind), mailbox_(mailbox) {
    if (kind == LeafKind::packed) {
        if (!pack_at_once(geometry, tree)) pack(geometry, tree);
        return;
    }
    order_as_leaves(geometry, tree);
    single_ = Leaves(geometry, tree.members, tree.leaves);
    ranges_ = std::move(tree.leaves);
    if (mailbox) members_ = std::move(tree.members);
}

void CellLeaves::pack(const Geometry& geometry, GridTree& tree) {
    LeafPacker packer(geometry);
    std::vector<std::uint32_t> words;
    words.reserve(tree.leaves.size());
    for (const LeafRange& leaf : tree.leaves)
        words.push_back(packer.add(members_of(tree, leaf)).bits());
    packed_ = std::move(packer).build();
    rename_leaves(tree, [&](std::uint32_t leaf) { return words[leaf]; });
}

/// In parallel; false, and nothing done, where some leaf is not of triangles, or of too many.
bool CellLeaves::pack_at_once(const Geometry& geometry, GridTree& tree) {
    constexpr std::uint32_t width = TriangleBlock::width;
    std::vector<std::uint32_t> first_block;
    first_block.reserve(tree.leaves.size());
    std::size_t blocks = 0;
    for (const LeafRange& leaf : tree.leaves) {
        const std::uint32_t own = (leaf.count + width - 1) / width;
        if (own > PackedLeaf::most_blocks) return false;
        first_block.push_back(static_cast<std::uint32_t>(blocks));
        blocks += own;
    }
    LeafPacker packer(geometry);
    if (!packer.make_room_for_triangles(blocks)) return false;
    std::vector<std::uint32_t> words(tree.leaves.size());
    tbb::parallel_for(std::size_t{0}, tree.leaves.size(), [&](std::size_t i) {
        words[i] = packer.set_triangles(first_block[i], members_of(tree, tree.leaves[i])).bits();
    });
    packed_ = std::move(packer).build();
    rename_leaves(tree, [&](std::uint32_t leaf) { return words[leaf]; });
    return true;
}

std::size_t CellLeaves::bytes() const {
    return packed_.bytes() + single_.bytes() + ranges_.size() * sizeof(LeafRange) +
           members_.size() * sizeof(std::uint32_t);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
