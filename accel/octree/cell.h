#pragma once

#include "accel/octree/lattice.h"
#include "accel/space/membership.h"

#include <memory>
#include <string>

/// An octree while it grows.
namespace rayshoot::inline RAYSHOOT_ISA {

struct OctreeCell {
    Box box;
    OctreePlace lattice;
    std::vector<std::uint32_t> members;                   ///< of a leaf, ascending
    std::array<float, 3> planes{};                        ///< of an interior cell, x, y, z
    std::unique_ptr<std::array<OctreeCell, 8>> children;  ///< bit `axis` of the place: upper half

    bool interior() const { return children != nullptr; }
};

/// Where a cell is cut.
enum class OctreePlanes : std::uint8_t {
    centre,  ///< Glassner 1984
    sah      ///< MacDonald & Booth 1990; Whang et al. 1995 (Octree-R)
};
/// When a cell stays a leaf although its members are more than the largest leaf's.
enum class OctreeStop : std::uint8_t {
    count,  ///< never, but for the depth
    cost    ///< when testing them is expected to cost no more than its children would
};

struct OctreeSettings {
    int depth = OctreeLattice::most_levels;  ///< of the deepest leaf; the root's is 0
    std::uint32_t largest_leaf = 1;
    OctreePlanes planes = OctreePlanes::centre;
    OctreeStop stop = OctreeStop::count;
    bool loose = false;  ///< each primitive in one cell alone, that of its centre (Ulrich 2000)
    double most_references = 16;  ///< of all leaves together, for each primitive
};

struct OctreeGrowth {
    OctreeCell root;
    /// Leaves that were not cut because of most_references.
    std::uint64_t held_back = 0;
};

/// In parallel; the same for any number of threads.
OctreeGrowth grow_octree(std::uint32_t primitives, const Membership& membership,
                         const OctreeSettings& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
