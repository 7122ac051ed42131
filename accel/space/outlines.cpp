#include "accel/space/outlines.h"

namespace rayshoot::inline RAYSHOOT_ISA {

Outlines::Outline OutlinedRuns::joined(const std::vector<Box>& boxes, std::size_t first,
                                       std::size_t end) {
    if (end - first == 1) return {boxes[first], static_cast<std::uint32_t>(first)};
    const std::size_t middle = first + (end - first) / 2;
    const Outlines::Outline before = joined(boxes, first, middle);
    return outlines_.join(before, joined(boxes, middle, end));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
