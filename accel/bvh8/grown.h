#pragma once

#include "accel/bvh8/bvh8.h"

/// One ray, in boxes grown by so much: for trees whose boxes are tighter than what they hold, and
/// rays from so far away that rounding makes up for that. Seldom asked, so it is simple.
namespace rayshoot::inline RAYSHOOT_ISA {

template <class Node>
template <Query Q, Counter C>
inline void WideBvh<Node>::trace_grown(const Ray& from, float extra, Hit& hit, C& count) const {
    const TestRay ray = leaves_.prepared(from);
    std::array<std::uint32_t, (Node::width - 1) * Stack::deepest + 1> pending;
    pending[0] = WideChild::node(0).bits();
    std::size_t waiting = 1;
    while (waiting > 0) {
        const WideChild next = WideChild::from(pending[--waiting]);
        if (!next.interior()) {
            count(Event::cell);
            leaves_.template test<Q>(next.leaf(), ray, hit, count);
            if (Q == Query::occluded && hit.primitive != no_primitive) return;
            continue;
        }
        const Node& node = node_at(next);
        count(Event::step);
        for (std::size_t i = 0; i < node.live(); ++i) {
            Box box;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box.lo[static_cast<int>(axis)] = plane(node.bounds, axis, axis, i);
                box.hi[static_cast<int>(axis)] = plane(node.bounds, axis, axis + 3, i);
            }
            count(Event::bounding_volume_test);
            if (!clip(ray, box.grown(extra), {from.t_min, hit.t}).empty())
                pending[waiting++] = node.children[i];
        }
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
