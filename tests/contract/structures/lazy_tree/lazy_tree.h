#pragma once

#include "accel/core/structure.h"
#include "tests/contract/structures/test_tree/test_tree.h"

/// A kd-tree that starts as one leaf and is refined by the rays that come: what it has learnt lies
/// in the Scratch, so its counts depend on the batches that a session has seen, but no answer does.
namespace rayshoot::contract {

class LazyTree {
public:
    static constexpr std::string_view name = "lazy_tree";
    static constexpr std::string_view summary = "test only: a kd-tree refined while tracing";
    static constexpr bool complete = true, remembers = true;
    static constexpr std::array<OptionInfo, 0> options{};
    static constexpr std::array<std::string_view, 1> configurations{"lazy_tree"};

    struct Scratch {
        KdTree tree;
        std::size_t bytes() const { return tree.bytes(); }
    };

    LazyTree(const BuildInput& input, const Options&)
        : geometry_(input.geometry), leaves_(one_leaf_each(input.geometry)) {}

    template <Query Q, Counter C>
    bool one(const Ray& ray, Source, Hit& hit, Scratch& scratch, C& count) const {
        if (scratch.tree.empty()) scratch.tree = KdTree(geometry_);
        const TestRay test_ray = leaves_.prepared(ray);
        const Interval all = clip(test_ray, geometry_.bounds(), {ray.t_min, hit.t});
        if (!all.empty()) visit<Q>(0, all, test_ray, hit, scratch, count);
        return true;
    }
    Footprint footprint() const { return {.bytes = leaves_.bytes()}; }

private:
    template <Query Q, Counter C>
    void visit(std::uint32_t number, Interval interval, const TestRay& ray, Hit& hit,
               Scratch& scratch, C& count) const;

    const Geometry& geometry_;
    Leaves leaves_;
};

template <Query Q, Counter C>
void LazyTree::visit(std::uint32_t number, Interval interval, const TestRay& ray, Hit& hit,
                     Scratch& scratch, C& count) const {
    if (scratch.tree.node(number).leaf() &&
        scratch.tree.split(geometry_, number, KdTree::Straddlers::in_both))
        count(Event::candidate_set);
    if (scratch.tree.node(number).leaf()) {
        count(Event::cell);
        for (const std::uint32_t primitive : scratch.tree.node(number).primitives) {
            leaves_.test<Q>({primitive, 1}, ray, hit, count);
            if (Q == Query::occluded && hit.primitive != no_primitive) return;
        }
        return;
    }
    const KdTree::Node& node =
        scratch.tree.node(number);  // children may move it: copy what is used
    const auto [axis, low] = std::pair(node.axis, node.low);
    const float t = ray.at(axis, node.plane);
    const bool descending = ray.descending[static_cast<std::size_t>(axis)];
    const bool inside = std::isnan(t);
    if (inside || interval.entry <= t)
        visit<Q>(low + descending,
                 {interval.entry, inside ? interval.exit : std::min(t, interval.exit)}, ray, hit,
                 scratch, count);
    if (Q == Query::occluded && hit.primitive != no_primitive) return;
    const float begin = inside ? interval.entry : std::max(t, interval.entry);
    if (begin <= interval.exit && begin <= hit.t)
        visit<Q>(low + !descending, {begin, interval.exit}, ray, hit, scratch, count);
}

}  // namespace rayshoot::contract
