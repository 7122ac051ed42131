#pragma once

#include "accel/core/leaves.h"
#include "accel/octree/cell.h"
#include "accel/simd/packed_leaves.h"

/// The leaves of an octree: their members, and how these are tested.
namespace rayshoot::inline RAYSHOOT_ISA {

/// The number of every leaf without members.
inline constexpr std::uint32_t empty_leaf = 0x7fffffff;

/// Leaves that have members, in depth-first order of the tree.
struct OctreeLists {
    std::vector<std::uint32_t> members;
    std::vector<LeafRange> leaves;

    /// Takes the members of a leaf; returns its number.
    std::uint32_t add(OctreeCell& leaf);
    /// Round the stored bounds of a leaf's members.
    Box bounds(const Geometry& geometry, std::size_t leaf) const;
};

enum class OctreeLeafTest : std::uint8_t {
    single,  ///< one by one; an any-hit ray stops at the first one that is hit (Havran 1999)
    packed   ///< side by side
};

/// Made of lists; tested by the numbers that these gave.
class OctreeLeaves {
public:
    OctreeLeaves() = default;
    OctreeLeaves(const Geometry& geometry, OctreeLists&& lists, OctreeLeafTest test);

    TestRay prepared(const Ray& ray) const {
        return test_ == OctreeLeafTest::single ? scalar_.prepared(ray) : packed_.prepared(ray);
    }
    template <Query Q, Counter C>
    void test(std::uint32_t leaf, const TestRay& ray, Hit& hit, C& count) const {
        if (test_ == OctreeLeafTest::single) scalar_.test<Q>(ranges_[leaf], ray, hit, count);
        else packed_.test<Q>(words_[leaf], ray, hit, count);
    }
    std::size_t bytes() const {
        return scalar_.bytes() + packed_.bytes() + ranges_.size() * sizeof(LeafRange) +
               words_.size() * sizeof(PackedLeaf);
    }

private:
    OctreeLeafTest test_ = OctreeLeafTest::packed;
    Leaves scalar_;
    std::vector<LeafRange> ranges_;  ///< of scalar leaves
    PackedLeaves packed_;
    std::vector<PackedLeaf> words_;  ///< of packed ones
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
