#pragma once

#include "accel/core/build_input.h"

#include <glm/common.hpp>

#include <algorithm>

/// Which primitives a cell of a space subdivision holds: grid, octree and BSP share it.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class Overlap : std::uint8_t {
    bounds,  ///< those whose stored bounds touch the cell
    exact,   ///< those of which a point, grown by the error radius, is in the closed cell
    havran   ///< those whose box by the rules of Havran 1999 touches it
};

class Membership {
public:
    /// Refers to the input's geometry.
    Membership(const BuildInput& input, Overlap overlap);

    /// What is to be subdivided: it encloses every box.
    const Box& space() const { return space_; }
    /// What is compared with cells first; touching counts.
    const Box& box(std::uint32_t primitive) const {
        return boxes_.empty() ? geometry_->bounds(primitive) : boxes_[primitive];
    }
    /// False only when no ray that cells are made_for() can be reported to hit the primitive in the
    /// closed cell.
    bool in_cell(std::uint32_t primitive, const Box& cell) const {
        return box(primitive).overlaps(cell) &&
               (overlap_ != Overlap::exact || geometry_->overlaps(primitive, cell, radius_));
    }
    /// Bounds of what in_cell() asks for; empty where it says false.
    Box clipped(std::uint32_t primitive, const Box& cell) const {
        if (overlap_ != Overlap::exact) return box(primitive).intersection(cell);
        // What is outside the cell, but within the radius, counts too.
        return geometry_->clipped_bounds(primitive, cell.grown(radius_), radius_)
            .intersection(cell);
    }
    /// How far from its primitive a hit may be reported, by a ray that cells are made_for(); 0
    /// where that does not matter.
    float radius() const { return radius_; }
    Overlap overlap() const { return overlap_; }
    /// How far from the centre of the scene bounds a ray may start that cells are made_for().
    float reach() const { return reach_; }

    /// Whether in_cell() holds for the ray: it does if the ray starts no farther from the centre of
    /// the scene bounds than the scene's diagonal, or than the eye, and the slab form takes no
    /// component of its direction for zero that is not. Other rays have to be answered without
    /// cells (outlines.h).
    bool made_for(const Ray& ray) const {
        const vec3 from_centre = (ray.origin - centre_) * per_reach_;
        // Rounding is covered: the radius is that of a somewhat larger reach.
        const bool near = dot(from_centre, from_centre) <= 1, lost = any_lost(ray.direction);
        return per_reach_ == 0 || (near && !lost);
    }

private:
    /// Whether a component is not zero, but its inverse infinite.
    static bool any_lost(const vec3& direction) {
        const vec3 size = glm::abs(direction);
        const auto lost = [](float x) { return (x > 0) & (x <= 0x1p-128f); };
        return lost(size.x) | lost(size.y) | lost(size.z);
    }

    const Geometry* geometry_;
    Overlap overlap_;
    std::vector<Box> boxes_;  ///< empty: the stored bounds
    Box space_;
    vec3 centre_{0};
    float reach_ = infinity;
    float per_reach_ = 0;  ///< 1 / reach; 0: whatever overlaps is exact for every ray
    float radius_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
