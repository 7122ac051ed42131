#include "accel/simd/quantised_boxes.h"

#include <algorithm>
#include <cmath>

namespace rayshoot::inline RAYSHOOT_ISA {

QuantisedBoxes::QuantisedBoxes(const Boxes<width>& boxes) {
    std::array<bool, width> live;
    for (std::size_t i = 0; i < width; ++i) {
        live[i] = boxes.planes[0][i] <= boxes.planes[3][i];
        shape_ |= static_cast<std::uint32_t>(live[i]) << (24 + i);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& los = boxes.planes[axis];
        const auto& his = boxes.planes[axis + 3];
        // Of an empty box no plane is the least or the largest.
        fit(axis, *std::min_element(los.begin(), los.end()),
            *std::max_element(his.begin(), his.end()));
        if (exponent(axis) == unbounded) continue;
        for (std::size_t i = 0; i < width; ++i) {
            if (!live[i]) continue;
            planes_[axis][i] = place_below(axis, los[i]);
            planes_[axis + 3][i] = place_above(axis, his[i]);
        }
    }
}

/// The smallest cell of which 255 are enough.
void QuantisedBoxes::fit(std::size_t axis, float lo, float hi) {
    const auto set_exponent = [&](std::uint32_t exponent) {
        shape_ = (shape_ & ~(0xffu << 8 * axis)) | exponent << 8 * axis;
    };
    if (!(std::isfinite(lo) && std::isfinite(hi))) return set_exponent(unbounded);
    origin_[axis] = lo;
    const double size = static_cast<double>(hi) - lo;
    const int too_small = size > 0 ? std::ilogb(size / 255) + 127 : 0;
    set_exponent(static_cast<std::uint32_t>(std::max(0, too_small)));
    while (plane_at(axis, 255) < hi) set_exponent(exponent(axis) + 1);
}

double QuantisedBoxes::cells_to(std::size_t axis, float plane) const {
    const double size = static_cast<double>(plane) - origin_[axis];
    return size > 0 ? std::min(size / cell(axis), 255.0) : 0;
}

// What is computed is true but for the rounding of the decoded plane, which decides.

std::uint8_t QuantisedBoxes::place_below(std::size_t axis, float plane) const {
    auto place = static_cast<std::uint8_t>(cells_to(axis, plane));
    while (plane_at(axis, place) > plane) --place;
    return place;
}

std::uint8_t QuantisedBoxes::place_above(std::size_t axis, float plane) const {
    auto place = static_cast<std::uint8_t>(std::ceil(cells_to(axis, plane)));
    while (plane_at(axis, place) < plane) ++place;
    return place;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
