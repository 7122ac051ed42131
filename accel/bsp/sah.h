#pragma once

#include "accel/bvh/reference.h"

/// The surface area heuristic for planes across the axes (MacDonald & Booth 1990).
namespace rayshoot::inline RAYSHOOT_ISA {

struct Sah {
    float step_cost = 1;        ///< of an interior node
    float test_cost = 2;        ///< of as many primitives as are tested at once
    float empty_factor = 0.8f;  ///< of a split's cost where a side is empty (Wald & Havran 2006)
    int bins = 32;              ///< per axis
};

/// How many primitives are tested at once.
inline constexpr std::uint32_t tests_at_once = 4;

inline float leaf_cost(const Sah& sah, std::uint32_t primitives) {
    return sah.test_cost * static_cast<float>((primitives + tests_at_once - 1) / tests_at_once);
}

/// A plane that divides a cell. A primitive that lies in the plane goes to one side.
struct KdSplit {
    float cost = infinity;  ///< infinite: there is none
    int axis = 0;
    float plane = 0;
    bool planar_left = true;

    /// Ties: the first axis, the lowest plane; so the order in which planes are tried is all one.
    bool better_than(const KdSplit& other) const {
        if (cost != other.cost) return cost < other.cost;
        if (axis != other.axis) return axis < other.axis;
        return plane < other.plane;
    }
    bool in_left(const Reference& reference) const {
        const auto [lo, hi] = faces(reference);
        return lo < plane || (planar_left && lo == hi && lo == plane);
    }
    bool in_right(const Reference& reference) const {
        const auto [lo, hi] = faces(reference);
        return hi > plane || (!planar_left && lo == hi && lo == plane);
    }

private:
    std::pair<float, float> faces(const Reference& reference) const {
        const auto i = static_cast<std::size_t>(axis);
        return {reference.lo[i], -reference.minus_hi[i]};
    }
};

/// The chances that a ray through a cell passes the part below a plane across an axis, or the part
/// above: linear in the plane.
struct KdChances {
    double left_at_lo = 0, left_slope = 0, lo = 0, right_at_lo = 0;

    KdChances(const Box& cell, int axis) {
        const dvec3 size = dvec3(cell.hi) - dvec3(cell.lo);
        const double across = size[(axis + 1) % 3], down = size[(axis + 2) % 3];
        const double area = across * down + size[axis] * (across + down);
        lo = cell.lo[axis];
        left_at_lo = across * down / area;
        left_slope = (across + down) / area;
        right_at_lo = left_at_lo + left_slope * size[axis];
    }
    float left(float plane) const {
        return static_cast<float>(left_at_lo + left_slope * (double(plane) - lo));
    }
    float right(float plane) const {
        return static_cast<float>(right_at_lo - left_slope * (double(plane) - lo));
    }
};

/// The cost of a plane with so many primitives below it and above it.
inline float split_cost(const Sah& sah, float left_chance, std::uint32_t left, float right_chance,
                        std::uint32_t right) {
    const float tests = left_chance * leaf_cost(sah, left) + right_chance * leaf_cost(sah, right);
    const float cost = sah.step_cost + tests;
    return left == 0 || right == 0 ? sah.empty_factor * cost : cost;
}

/// The best of all planes at faces of the references' boxes: each against each, side by side.
KdSplit counted_split(const Sah& sah, const Box& cell, std::span<const Reference> references);
inline constexpr std::size_t most_counted = 256;  ///< references

/// The best of those that cut off nothing but empty space: where one test is enough for all
/// references, no other plane can pay.
KdSplit cutting_split(const Sah& sah, const Box& cell, std::span<const Reference> references);

/// The best of evenly spaced planes and of those that cut off nothing but empty space.
KdSplit binned_split(const Sah& sah, const Box& cell, std::span<const Reference> references);

}  // namespace rayshoot::inline RAYSHOOT_ISA
