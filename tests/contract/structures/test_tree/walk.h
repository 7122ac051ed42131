#pragma once

#include "accel/core/leaves.h"

#include <algorithm>

/// The kd-tree's traversal, with the places where a fault can be planted.
namespace rayshoot::contract {

enum class Fault : std::uint8_t {
    none,
    skipped_child,    ///< the far child of the root is not visited
    wrong_order,      ///< the far child first, and done when it has a hit
    early_stop,       ///< done with the first leaf that has a hit, wherever that hit lies
    stop_at_tie,      ///< a cell that begins exactly at the best hit is not visited
    lost_straddler,   ///< a primitive on both sides of a plane is filed on one
    unclamped_t,      ///< one primitive in eight reports its t without the clamp
    wrong_tie,        ///< at equal t the last primitive tested wins
    closed_limit,     ///< t == t_max counts as a hit
    negative_zero,    ///< -0 taken for an ascending direction
    forgotten_t_min,  ///< t_min taken for 0 by the traversal
    forgotten_time,   ///< every ray at time 0
    stale_mailbox,    ///< what the ray before had tested is not tested again
    shared_any_hit,   ///< occluded ends at any primitive met, in its interval or not
    lost_remainder,   ///< the last ray of a batch that is no multiple of 8 is left out
    declining,        ///< a complete structure that declines now and then
    uncounted_cells,  ///< counts more empty cells than cells
};

template <Query Q, class Tree, Counter C>
class Walk {
public:
    Walk(const Tree& tree, const Ray& ray, Hit& hit, typename Tree::Scratch& scratch, C& count)
        : tree_(tree), ray_(planted(tree, ray)), hit_(hit), scratch_(scratch), count_(count) {}

    void run() {
        const float begin = tree_.has(Fault::forgotten_t_min) ? 0.0f : ray_.t_min;
        count_(Event::bounding_volume_test);
        const Interval interval = clip(ray_, tree_.tree().node(0).cell, {begin, hit_.t});
        if (!interval.empty()) visit(0, interval);
    }

private:
    static TestRay planted(const Tree& tree, const Ray& given) {
        Ray ray = given;
        if (tree.has(Fault::forgotten_time)) ray.time = 0;
        TestRay test_ray = tree.leaves().prepared(ray);
        if (tree.has(Fault::negative_zero))
            for (int axis = 0; axis < 3; ++axis)
                test_ray.descending[static_cast<std::size_t>(axis)] = ray.direction[axis] < 0;
        return test_ray;
    }

    bool done() const { return Q == Query::occluded && hit_.primitive != no_primitive; }

    void visit(std::uint32_t number, Interval interval) {
        const KdTree::Node& node = tree_.tree().node(number);
        if (node.leaf()) return visit_leaf(node, interval);
        count_(Event::step);
        const float t = ray_.at(node.axis, node.plane);
        const bool descending = ray_.descending[static_cast<std::size_t>(node.axis)];
        const std::uint32_t near = node.low + descending, far = node.low + !descending;
        if (std::isnan(t)) {  // inside the plane: both cells, all the way
            visit(near, interval);
            if (!done()) visit(far, interval);
            return;
        }
        if (tree_.has(Fault::wrong_order)) {
            if (t <= interval.exit) visit(far, {std::max(t, interval.entry), interval.exit});
            if (hit_.primitive != no_primitive) return;
        }
        if (interval.entry <= t) visit(near, {interval.entry, std::min(t, interval.exit)});
        if (done() || stopped_ || t > interval.exit || tree_.has(Fault::wrong_order)) return;
        const float begin = std::max(t, interval.entry);
        const bool behind = tree_.has(Fault::stop_at_tie) ? begin >= hit_.t : begin > hit_.t;
        if (tree_.has(Fault::skipped_child) && number == 0) return;
        if (!behind) visit(far, {begin, interval.exit});
    }

    void visit_leaf(const KdTree::Node& leaf, Interval interval) {
        count_(Event::cell);
        if (leaf.primitives.empty() || tree_.has(Fault::uncounted_cells))
            count_(Event::empty_cell, tree_.has(Fault::uncounted_cells) ? 2 : 1);
        for (const std::uint32_t primitive : leaf.primitives) {
            if (scratch_.seen[primitive]) {
                count_(Event::mailbox_skip);
                continue;
            }
            scratch_.seen[primitive] = true;
            test(primitive);
            if (done()) return;
        }
        if (tree_.has(Fault::early_stop) && hit_.primitive != no_primitive &&
            hit_.t >= interval.entry)
            stopped_ = true;
    }

    void test(std::uint32_t primitive) {
        if (tree_.has(Fault::unclamped_t) && primitive % 8 == 3) return test_unclamped(primitive);
        Hit hit = hit_;
        if (tree_.has(Fault::wrong_tie)) hit.primitive = no_primitive;
        if (tree_.has(Fault::shared_any_hit) && Q == Query::occluded) hit.t = infinity;
        tree_.leaves().template test<Q>({primitive, 1}, ray_, hit, count_);
        if (hit.primitive != no_primitive) hit_ = hit;
    }

    /// What a structure does that has a triangle loop of its own.
    void test_unclamped(std::uint32_t primitive) {
        const PrimitiveRef& ref = tree_.geometry().ref(primitive);
        if (ref.kind != PrimitiveKind::triangle || ref.motion != no_motion) return;
        count_(Event::object_test);
        intersect(tree_.geometry().triangle(ref.index), ray_, [&](float t, float u, float v) {
            count_(Event::object_hit);
            if (t > ray_.t_min && (t < hit_.t || (t == hit_.t && primitive < hit_.primitive)))
                hit_ = {t, primitive, u, v};
        });
    }

    const Tree& tree_;
    const TestRay ray_;
    Hit& hit_;
    typename Tree::Scratch& scratch_;
    C& count_;
    bool stopped_ = false;
};

}  // namespace rayshoot::contract
