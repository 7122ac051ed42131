#pragma once

#include "accel/simd/sphere_block.h"
#include "accel/simd/watertight_block.h"

/// The leaves of a structure as blocks of triangles, blocks of spheres, and the rest.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A leaf of PackedLeaves in one word, whose highest bit is always clear: the structure's to use.
class PackedLeaf {
public:
    static constexpr std::uint32_t most_blocks = 8;  ///< of a leaf of one kind: others are mixed
    /// How many blocks, up to the leaf's last one, its word can tell apart.
    static constexpr std::uint32_t most_triangle_blocks = 1u << 27, most_sphere_blocks = 1u << 26;
    static constexpr std::uint32_t most_mixed = (1u << 29) - 1;

    /// Blocks `first` .. `first + count` and nothing else.
    static PackedLeaf triangles(std::uint32_t first, std::uint32_t count) {
        return PackedLeaf(first * most_blocks | (count - 1));
    }
    static PackedLeaf spheres(std::uint32_t first, std::uint32_t count) {
        return PackedLeaf(other_bit | sphere_bit | first * most_blocks | (count - 1));
    }
    /// Whatever else, by its number among the mixed leaves.
    static PackedLeaf mixed(std::uint32_t number) { return PackedLeaf(other_bit | number); }
    static PackedLeaf from(std::uint32_t bits) { return PackedLeaf(bits); }

    std::uint32_t bits() const { return bits_; }
    bool only_triangles() const { return (bits_ & other_bit) == 0; }
    bool is_mixed() const { return (bits_ & (other_bit | sphere_bit)) == other_bit; }
    std::uint32_t number() const { return bits_ & ~other_bit; }
    /// Of a leaf that is not mixed.
    std::uint32_t first_block() const {
        return (only_triangles() ? bits_ : bits_ & ~(other_bit | sphere_bit)) / most_blocks;
    }
    std::uint32_t block_count() const { return bits_ % most_blocks + 1; }
    /// Of a leaf of several blocks: the others.
    PackedLeaf after_first() const { return PackedLeaf(bits_ + most_blocks - 1); }

private:
    static constexpr std::uint32_t other_bit = 0x40000000, sphere_bit = 0x20000000;
    explicit PackedLeaf(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_;
};

/// Four triangles or eight spheres; the leaf knows which.
union LeafBlock {
    TriangleBlock triangles;
    SphereBlock spheres;

    LeafBlock() {}  // one that is still to be set
    LeafBlock(const TriangleBlock& block) : triangles(block) {}
    LeafBlock(const SphereBlock& block) : spheres(block) {}
};
static_assert(sizeof(TriangleBlock) == sizeof(SphereBlock));

/// Made by a LeafPacker. Triangles and spheres that stand still are tested side by side, all else
/// by Leaves, with the same answers and, for Query::closest, the same counts. For Query::occluded
/// Leaves stops after the primitive that is hit, this after its block.
class PackedLeaves {
public:
    PackedLeaves() = default;

    /// What test() needs of a ray, computed once.
    TestRay prepared(const Ray& ray) const { return {ray, precision_}; }

    /// Tests the ray against every primitive of a leaf; for Query::occluded until one is hit.
    template <Query Q, Counter C>
    void test(PackedLeaf leaf, const TestRay& ray, Hit& hit, C& count) const {
        if (leaf.only_triangles() && precision_ == Precision::standard) [[likely]]
            return test_triangles<Q, Precision::standard>(leaf.first_block(), leaf.block_count(),
                                                          ray, hit, count);
        test_runs<Q>(leaf, ray, hit, count);
    }

    /// Where the blocks begin, and the bytes from there to a leaf's first one, to be asked for
    /// early; to no avail for a mixed leaf.
    const std::byte* first() const { return reinterpret_cast<const std::byte*>(blocks_.data()); }
    static std::size_t offset(PackedLeaf leaf) {
        return std::size_t{leaf.bits() %
                           (PackedLeaf::most_sphere_blocks * PackedLeaf::most_blocks) /
                           PackedLeaf::most_blocks} *
               sizeof(LeafBlock);
    }
    /// For those who test many rays at once. Of a leaf of triangles, or of one of spheres.
    template <class Block>
    const Block& block(std::uint32_t i) const {
        if constexpr (std::is_same_v<Block, TriangleBlock>) return blocks_[i].triangles;
        else return blocks_[i].spheres;
    }
    float padding() const { return padding_; }
    Precision precision() const { return precision_; }

    std::size_t bytes() const {
        return blocks_.size() * sizeof(LeafBlock) + mixed_.size() * sizeof(Runs) + others_.bytes();
    }

private:
    friend class LeafPacker;
    /// Blocks of triangles, after them blocks of spheres, and slots of `others_`.
    struct Runs {
        std::uint32_t first_block, triangle_blocks, sphere_blocks;
        LeafRange others;
    };
    Runs runs(PackedLeaf leaf) const;

    template <Query Q, Precision P, Counter C>
    void test_triangles(std::uint32_t first, std::uint32_t blocks, const TestRay& ray, Hit& hit,
                        C& count) const;
    template <Query Q, Counter C>
    void test_spheres(std::uint32_t first, std::uint32_t blocks, const TestRay& ray, Hit& hit,
                      C& count) const;
    /// Out of the traversal loops, whose code it would push apart.
    template <Query Q, Counter C>
    [[gnu::noinline]] void test_runs(PackedLeaf leaf, const TestRay& ray, Hit& hit, C& count) const;
    template <Query Q>
    static bool answered(const Hit& hit) {
        return Q == Query::occluded && hit.primitive != no_primitive;
    }

    PagedVector<LeafBlock> blocks_;
    std::vector<Runs> mixed_;
    Leaves others_;
    float padding_ = 0;
    Precision precision_ = Precision::standard;
};

template <Query Q, Precision P, Counter C>
inline void PackedLeaves::test_triangles(std::uint32_t first, std::uint32_t blocks,
                                         const TestRay& ray, Hit& hit, C& count) const {
    for (std::uint32_t i = 0; i < blocks; ++i) {
        const TriangleBlock& block = blocks_[first + i].triangles;
        if constexpr (P == Precision::standard) rayshoot::test(block, ray, padding_, hit, count);
        else test_watertight(block, ray, padding_, hit, count);
        if (answered<Q>(hit)) return;
    }
}

template <Query Q, Counter C>
inline void PackedLeaves::test_spheres(std::uint32_t first, std::uint32_t blocks,
                                       const TestRay& ray, Hit& hit, C& count) const {
    for (std::uint32_t i = 0; i < blocks; ++i) {
        rayshoot::test(blocks_[first + i].spheres, ray, padding_, hit, count);
        if (answered<Q>(hit)) return;
    }
}

inline PackedLeaves::Runs PackedLeaves::runs(PackedLeaf leaf) const {
    if (leaf.is_mixed()) return mixed_[leaf.number()];
    const std::uint32_t first = leaf.first_block(), blocks = leaf.block_count();
    if (leaf.only_triangles()) return {first, blocks, 0, {}};
    return {first, 0, blocks, {}};
}

template <Query Q, Counter C>
void PackedLeaves::test_runs(PackedLeaf leaf, const TestRay& ray, Hit& hit, C& count) const {
    const Runs of = runs(leaf);
    if (precision_ == Precision::standard)
        test_triangles<Q, Precision::standard>(of.first_block, of.triangle_blocks, ray, hit, count);
    else
        test_triangles<Q, Precision::watertight>(of.first_block, of.triangle_blocks, ray, hit,
                                                 count);
    if (answered<Q>(hit)) return;
    test_spheres<Q>(of.first_block + of.triangle_blocks, of.sphere_blocks, ray, hit, count);
    if (answered<Q>(hit) || of.others.count == 0) return;
    others_.template test<Q>(of.others, ray, hit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
