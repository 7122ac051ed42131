#include "accel/octree/planes.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr int positions = 10;  // Havran 1999

/// The members' extents along one axis, inside the cell.
struct Extents {
    std::vector<float> lo, hi;  ///< each ascending
    float median;               ///< of the centres

    Extents(const OctreeCell& cell, const Membership& membership, int axis) {
        std::vector<float> centres;
        for (const std::uint32_t primitive : cell.members) {
            const Box part = membership.box(primitive).intersection(cell.box);
            lo.push_back(part.lo[axis]);
            hi.push_back(part.hi[axis]);
            centres.push_back(part.centre()[axis]);
        }
        std::sort(lo.begin(), lo.end());
        std::sort(hi.begin(), hi.end());
        const auto middle = centres.begin() + static_cast<std::ptrdiff_t>(centres.size() / 2);
        std::nth_element(centres.begin(), middle, centres.end());
        median = *middle;
    }
    double below(float plane) const {
        return static_cast<double>(std::upper_bound(lo.begin(), lo.end(), plane) - lo.begin());
    }
    double above(float plane) const {
        return static_cast<double>(hi.end() - std::lower_bound(hi.begin(), hi.end(), plane));
    }
};

/// The box's half area if its side along `axis` had this length.
double half_area(const Box& box, int axis, double length) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double a = double(box.hi[u]) - box.lo[u], b = double(box.hi[v]) - box.lo[v];
    return a * b + length * (a + b);
}

float best_plane(const OctreeCell& cell, const Membership& membership, int axis) {
    const Extents extents(cell, membership, axis);
    const double lo = cell.box.lo[axis], hi = cell.box.hi[axis];
    const double middle = 0.5 * lo + 0.5 * hi;
    float best = static_cast<float>(middle);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < positions; ++i) {
        const double share = double(i) / (positions - 1);
        const auto plane = static_cast<float>(middle + (extents.median - middle) * share);
        const double cost = extents.below(plane) * half_area(cell.box, axis, plane - lo) +
                            extents.above(plane) * half_area(cell.box, axis, hi - plane);
        if (!(cost < least)) continue;
        least = cost;
        best = plane;
    }
    return std::clamp(best, cell.box.lo[axis], cell.box.hi[axis]);
}

}  // namespace

std::array<float, 3> sah_planes(const OctreeCell& cell, const Membership& membership) {
    return {best_plane(cell, membership, 0), best_plane(cell, membership, 1),
            best_plane(cell, membership, 2)};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
