#pragma once

#include "accel/bvh8/bvh8.h"

/// The tree of ../bvh8 with the children's bounds in a byte a plane: less than half the bytes a
/// node, more work a step.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Bvh8q : WideBvh<WideNode8q> {
    using WideBvh::WideBvh;
    static constexpr std::string_view name = "bvh8q";
    static constexpr std::string_view summary =
        "bounding-volume hierarchy: binned SAH, 8-wide, 8-bit bounds, SIMD leaves, packets, rays "
        "in flight";
    static constexpr std::array<std::string_view, 2> configurations{"bvh8q",
                                                                    "bvh8q:packets=off,flight=1"};
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
