#pragma once

#include "accel/bsp/layout.h"
#include "accel/space/outlines.h"

namespace rayshoot::inline RAYSHOOT_ISA {

static_assert(deepest_bsp + 2 <= Outlines::most_levels);

/// Round sub-trees, whose roots are the places.
Outlines outlined(const Geometry& geometry, const BspSketch& sketch, const BspTree& tree);

/// visit(leaf) for all leaves of the sub-trees whose boxes the ray meets before `hit`, until it is
/// true.
template <class Visit, Counter C>
inline void each_leaf(const BspTree& tree, const Outlines& outlines, const SlabRay& ray,
                      float t_min, const Hit& hit, const Visit& visit, C& count) {
    const auto visit_all = [&](std::uint32_t root) {
        std::array<std::uint32_t, deepest_bsp + 2> later;
        std::size_t size = 0;
        later[size++] = root;
        while (size > 0) {
            const BspNode node = tree.nodes[later[--size]];
            if (node.is_leaf()) {
                if (visit(node)) return true;
                continue;
            }
            count(Event::step);
            later[size++] = node.children() + 1;
            later[size++] = node.children();
        }
        return false;
    };
    outlines.each(ray, t_min, hit, visit_all, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
