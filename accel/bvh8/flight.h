#pragma once

#include "accel/bvh8/node.h"
#include "accel/core/leaves.h"

/// A ray on its way through the tree.
namespace rayshoot::inline RAYSHOOT_ISA {

struct Flight {
    static constexpr std::size_t deepest = 64;  ///< levels of the tree
    /// A node leaves seven children behind at most; eight are written at once.
    static constexpr std::size_t stack_size = (WideNode::width - 1) * deepest + WideNode::width + 1;

    TestRay ray{Ray{}, Precision::standard};
    Hit hit;
    WideChild next = WideChild::none();              ///< what is visited next
    std::size_t number = 0;                          ///< of the ray in its batch
    std::size_t top = 0;                             ///< how much of the stack is in use
    std::array<std::uint32_t, stack_size> children;  ///< still to be visited, and ...
    std::array<float, stack_size> entries;           ///< ... where the ray enters them

    /// `best`: the nearest hit so far.
    void start(const Ray& from, const Hit& best, std::size_t n, Precision precision) {
        std::construct_at(&ray, from, precision);  // in place: a copy would wait for its stores
        hit = best;
        next = WideChild::node(0);
        number = n;
        children[0] = WideChild::none().bits();
        entries[0] = -infinity;
        top = 1;
    }
    void push(WideChild child, float entry) {
        children[top] = child.bits();
        entries[top++] = entry;
    }
    /// Closed: what begins exactly at the hit may hold a tie with a smaller number.
    void pop() {
        do --top;
        while (entries[top] > hit.t);
        next = WideChild::from(children[top]);
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
