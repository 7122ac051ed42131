#pragma once

#include "accel/bsp/sketch.h"

#include <string>
#include <vector>

/// Scenes for builders of BSP trees, and a walk over what they make of them.
namespace rayshoot::bsp_test {

struct NamedGeometry {
    std::string name;
    Geometry geometry;
};

/// Triangles with edges up to `size`, with centres in the unit cube.
Geometry random_triangles(std::size_t count, float size, unsigned seed);
/// Of many shapes; small enough to be looked at one by one.
std::vector<NamedGeometry> hard_scenes();

/// visit(leaf's members, its cell) for every leaf, left before right.
template <class Visit>
void each_leaf(const BspSketch& sketch, const Box& cell, const Visit& visit,
               std::uint32_t number = 0) {
    const BspSketch::Node& node = sketch.nodes[number];
    if (node.kind == BspSketch::Kind::part)
        return each_leaf(*sketch.parts[node.first], cell, visit);
    if (node.kind == BspSketch::Kind::leaf) return visit(sketch.members_of(node), cell);
    Box left = cell, right = cell;
    left.hi[node.axis] = right.lo[node.axis] = node.plane;
    each_leaf(sketch, left, visit, node.first);
    each_leaf(sketch, right, visit, node.first + 1);
}

}  // namespace rayshoot::bsp_test
