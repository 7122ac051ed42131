#pragma once

#include "accel/core/box.h"

/// The planes that halve a box again and again along each axis.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Where a cell of an octree lies if every cut is in the middle: along each axis, how many cells of
/// its own size come before it.
struct OctreePlace {
    std::array<std::uint32_t, 3> place{};
    int level = 0;  ///< 0: the whole

    /// Bit `axis` of `i` chooses the upper half.
    OctreePlace child(unsigned i) const {
        OctreePlace below{{}, level + 1};
        for (unsigned axis = 0; axis < 3; ++axis)
            below.place[axis] = 2 * place[axis] + (i >> axis & 1);
        return below;
    }
};

class OctreeLattice {
public:
    static constexpr int most_levels = 20;

    OctreeLattice() = default;
    explicit OctreeLattice(const Box& space) : space_(space) {}

    /// The plane in the middle of a cell across an axis. One formula, from a whole number of the
    /// finest planes, so that neighbours of any size have the same planes, bit for bit; it never
    /// decreases with that number, because every rounding is monotone.
    float middle(int axis, const OctreePlace& cell) const {
        const auto twice = 2.0 * cell.place[static_cast<std::size_t>(axis)] + 1;
        const double share = std::ldexp(twice, -cell.level - 1);
        const double lo = space_.lo[axis], hi = space_.hi[axis];
        const auto plane = static_cast<float>(lo + (hi - lo) * share);
        return plane > space_.hi[axis] ? space_.hi[axis] : plane;
    }
    const Box& space() const { return space_; }

private:
    Box space_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
