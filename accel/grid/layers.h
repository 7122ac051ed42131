#pragma once

#include "accel/grid/lattice.h"

/// The slow and careful walk: every cell that a ray touches, even if it runs inside a plane, so
/// that it touches two cells all the way.
namespace rayshoot::inline RAYSHOOT_ISA {

class Layers {
public:
    Layers(const Lattice& lattice, const SlabRay& ray) : lattice_(lattice), ray_(ray) {}

    /// Calls visit(cell, t) for the cells that the ray touches from t_min on, t being where it
    /// comes to them, in the order of t; until `reach()`, asked again and again, is less than t.
    template <class Visit, class Reach>
    void walk(float t_min, const Visit& visit, const Reach& reach);

private:
    static std::size_t at(int axis) { return static_cast<std::size_t>(axis); }
    bool descending(int axis) const { return ray_.descending[at(axis)]; }
    int forward(int axis) const { return descending(axis) ? -1 : 1; }
    int end(int axis) const { return descending(axis) ? -1 : lattice_.cells()[at(axis)]; }
    float enter(int axis, int i) const {
        return ray_.at(axis, lattice_.plane(axis, i + descending(axis)));
    }
    float leave(int axis, int i) const {
        return ray_.at(axis, lattice_.plane(axis, i + 1 - descending(axis)));
    }
    /// Of the lattice.
    Interval interval(float t_min) const;
    /// Forgets what lies behind t.
    void drop_before(float t);
    /// The axis along which cells are touched next, if any, and where; t is never NaN.
    std::pair<int, float> next() const;
    template <class Visit>
    void visit_block(const Cell& from, float t, const Visit& visit) const;

    const Lattice& lattice_;
    const SlabRay& ray_;
    Cell first_{}, last_{};  ///< in the ray's order
};

inline Interval Layers::interval(float t_min) const {
    Interval interval{t_min, infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const int end_of_all = lattice_.cells()[at(axis)];
        const float near = enter(axis, descending(axis) ? end_of_all - 1 : 0);
        const float far = leave(axis, end(axis) - forward(axis));
        interval.entry = near > interval.entry ? near : interval.entry;
        interval.exit = far < interval.exit ? far : interval.exit;
    }
    return interval;
}

inline void Layers::drop_before(float t) {
    for (int axis = 0; axis < 3; ++axis)
        while (first_[at(axis)] != last_[at(axis)] && leave(axis, first_[at(axis)]) < t)
            first_[at(axis)] += forward(axis);
}

inline std::pair<int, float> Layers::next() const {
    std::pair<int, float> next{-1, infinity};
    for (int axis = 0; axis < 3; ++axis) {
        const int i = last_[at(axis)] + forward(axis);
        if (i == end(axis)) continue;
        const float t = enter(axis, i);
        if (t < next.second) next = {axis, t};
    }
    return next;
}

template <class Visit>
inline void Layers::visit_block(const Cell& from, float t, const Visit& visit) const {
    CellRange block{from, last_};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (block.first[axis] > block.last[axis]) std::swap(block.first[axis], block.last[axis]);
    for_each_cell(block, [&](const Cell& cell) { visit(cell, t); });
}

template <class Visit, class Reach>
inline void Layers::walk(float t_min, const Visit& visit, const Reach& reach) {
    const auto [entry, exit] = interval(t_min);
    if (!(entry <= exit) || reach() < entry) return;
    for (int axis = 0; axis < 3; ++axis) {
        int& first = first_[at(axis)];
        int& last = last_[at(axis)];
        const int beyond = end(axis), stride = forward(axis);
        first = descending(axis) ? lattice_.cells()[at(axis)] - 1 : 0;
        while (first + stride != beyond && leave(axis, first) < entry) first += stride;
        last = first;
        // NaN bounds nothing: inside a plane the cells of both sides are touched.
        while (last + stride != beyond && !(enter(axis, last + stride) > entry)) last += stride;
    }
    visit_block(first_, entry, visit);
    while (true) {
        const auto [axis, t] = next();
        if (axis < 0 || t > exit || reach() < t) return;
        drop_before(t);
        last_[at(axis)] += forward(axis);
        Cell layer = first_;
        layer[at(axis)] = last_[at(axis)];
        visit_block(layer, t, visit);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
