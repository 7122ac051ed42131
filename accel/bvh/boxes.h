#pragma once

#include "accel/core/geometry.h"

/// What the builders of hierarchies are given of a geometry.
namespace rayshoot::inline RAYSHOOT_ISA {

inline std::vector<Box> boxes_of(const Geometry& geometry) {
    std::vector<Box> boxes;
    boxes.reserve(geometry.size());
    for (std::uint32_t i = 0; i < geometry.size(); ++i) boxes.push_back(geometry.bounds(i));
    return boxes;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
