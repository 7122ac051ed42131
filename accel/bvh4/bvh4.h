#pragma once

#include "accel/bvh8/bvh8.h"

/// The tree of ../bvh8 with four children a node: half the bytes a node, more steps a ray.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Bvh4 : WideBvh<WideNode4> {
    using WideBvh::WideBvh;
    static constexpr std::string_view name = "bvh4";
    static constexpr std::string_view summary =
        "bounding-volume hierarchy: binned SAH, 4-wide, SIMD leaves, packets, rays in flight";
    static constexpr std::array<std::string_view, 2> configurations{"bvh4",
                                                                    "bvh4:packets=off,flight=1"};
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
