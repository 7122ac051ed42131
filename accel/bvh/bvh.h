#pragma once

#include "accel/bvh/builders.h"
#include "accel/core/structure.h"

/// Bounding-volume hierarchy of boxes, two children a node, one ray at a time: the readable
/// reference. Built by binned surface-area heuristic (Wald 2007); see README.md.
namespace rayshoot::inline RAYSHOOT_ISA {

class Bvh {
public:
    static constexpr std::string_view name = "bvh";
    static constexpr std::string_view summary =
        "bounding-volume hierarchy: binned SAH, 2-wide, one ray at a time";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array options{
        build_option, OptionInfo{"leaf", "1 to 64", "4", "most primitives in a leaf"},
        OptionInfo{"bins", "2 to 256", "16", "bins per axis that a split is chosen from"}};
    static constexpr std::array<std::string_view, 5> configurations{
        "bvh", "bvh:build=fast", "bvh:build=high", "bvh:leaf=1", "bvh:leaf=8,bins=4"};
    static constexpr int deepest = 64;  ///< levels; the builder keeps to it, the stack relies on it
    struct Scratch {};

    Bvh(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    bool one(const Ray& ray, Source, Hit& hit, Scratch&, C& count) const;
    Footprint footprint() const { return footprint_; }

    /// An interior node (count 0: `first` is a node), a leaf (slots first .. first + count), or
    /// absent.
    struct Child {
        std::uint32_t first, count;
        bool interior() const { return count == 0; }
    };
    static constexpr std::uint32_t absent = 0xffffffff;
    /// One cache line: the bounds of both children, and what they are.
    struct alignas(64) Node {
        Boxes<2> bounds;
        std::array<Child, 2> child{Child{0, absent}, Child{0, absent}};
    };
    static_assert(sizeof(Node) == 64);

private:
    PagedVector<Node> nodes_;
    Leaves leaves_;
    Footprint footprint_;
};

template <Query Q, Counter C>
inline bool Bvh::one(const Ray& incoming, Source, Hit& hit, Scratch&, C& count) const {
    struct Pending {
        Child child;
        float entry;
    };
    const TestRay ray = leaves_.prepared(incoming);
    const SlabRay slabs = ray;  // a copy that no call can reach, so that it stays in registers
    std::array<Pending, deepest + 1> stack;
    Pending* top = stack.data();
    Child next{0, 0};
    float nearest = hit.t;
    while (true) {
        if (next.interior()) {
            const Node& node = nodes_[next.first];
            count(Event::step);
            if constexpr (C::counts)
                for (const Child& child : node.child)
                    count(Event::bounding_volume_test, child.count != absent);
            const auto interval = clip(slabs, node.bounds, {incoming.t_min, nearest});
            // Branches, not selections: what the processor guesses right, it need not wait for.
            if (interval.met(0)) {
                next = node.child[0];
                if (!interval.met(1)) continue;
                if (interval.entry[0] <= interval.entry[1]) {
                    *top++ = {node.child[1], interval.entry[1]};
                } else {
                    *top++ = {node.child[0], interval.entry[0]};
                    next = node.child[1];
                }
                continue;
            }
            if (interval.met(1)) {
                next = node.child[1];
                continue;
            }
        } else {
            count(Event::cell);
            leaves_.template test<Q>({next.first, next.count}, ray, hit, count);
            if constexpr (Q == Query::occluded)
                if (hit.primitive != no_primitive) return true;
            nearest = hit.t;
        }
        // Closed: what begins exactly at the hit may hold a tie with a smaller number.
        do {
            if (top == stack.data()) return true;
            --top;
        } while (top->entry > nearest);
        next = top->child;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
