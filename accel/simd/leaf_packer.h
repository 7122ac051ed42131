#pragma once

#include "accel/simd/packed_leaves.h"

/// Collects leaves; in memory they follow each other in the order in which they are added.
namespace rayshoot::inline RAYSHOOT_ISA {

class LeafPacker {
public:
    /// Refers to the geometry, as do the leaves where they hold more than triangles and spheres.
    explicit LeafPacker(const Geometry& geometry);

    /// `members`: primitive numbers. Throws std::length_error where there are too many to be
    /// numbered.
    PackedLeaf add(std::span<const std::uint32_t> members);

    /// Where the geometry has nothing but triangles that stand still: room for the blocks of all
    /// leaves, to be set in any order and at once. False, and nothing done, where it has, or where
    /// so many blocks cannot be numbered.
    bool make_room_for_triangles(std::size_t blocks);
    PackedLeaf set_triangles(std::uint32_t first_block, std::span<const std::uint32_t> members);

    PackedLeaves build() &&;

private:
    template <class Block>
    std::uint32_t add_blocks(std::span<const std::uint32_t> members);
    void set(TriangleBlock& block, std::size_t lane, std::uint32_t primitive) const;
    void set(SphereBlock& block, std::size_t lane, std::uint32_t primitive) const;

    const Geometry* geometry_;
    PackedLeaves leaves_;
    std::vector<std::uint32_t> triangles_, spheres_;  ///< of the leaf that is being added
    std::vector<std::uint32_t> others_;               ///< of all leaves
    std::vector<LeafRange> ranges_;                   ///< in `others_`
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
