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
    /// False only when no ray of which extra() is 0 can be reported to hit the primitive in the
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
    /// How far from its primitive a hit may be reported, by a ray of which extra() is 0; 0 where
    /// that does not matter.
    float radius() const { return radius_; }
    Overlap overlap() const { return overlap_; }
    /// How far from the centre of the scene bounds a ray may start to have an extra() of 0.
    float reach() const { return reach_; }

    /// How much farther outside its cells a ray's hits can be reported, because it starts far away:
    /// the cells that it visits have to be grown by as much. 0 for the rays that structures are
    /// made for: those that start no farther from the centre of the scene bounds than the scene's
    /// diagonal, or than the eye. Infinite where a component of the direction is so small that the
    /// slab form takes it for zero, and so knows no cell but the first.
    float extra(const Ray& ray) const {
        if (made_for(ray)) return 0;
        const float distance = std::sqrt(dot(ray.origin - centre_, ray.origin - centre_));
        return any_lost(ray.direction) ? infinity
                                       : std::max(distance - reach_, 0.0f) * radius_per_distance_;
    }
    /// Whether that is 0, for those who ask for every ray.
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
    float radius_per_distance_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
