#pragma once

#include "accel/core/build_input.h"

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
        return overlap_ == Overlap::exact ? geometry_->clipped_bounds(primitive, cell, radius_)
                                          : box(primitive).intersection(cell);
    }

    /// How much farther outside its cells a ray's hits can be reported, because it starts far away:
    /// the cells that it visits have to be grown by as much. 0 for the rays that structures are
    /// made for: those that start no farther from the centre of the scene bounds than the scene's
    /// diagonal, or than the eye.
    float extra(const Ray& ray) const {
        const float distance = std::sqrt(dot(ray.origin - centre_, ray.origin - centre_));
        return distance <= reach_ ? 0 : (distance - reach_) * radius_per_distance_;
    }

private:
    const Geometry* geometry_;
    Overlap overlap_;
    std::vector<Box> boxes_;  ///< empty: the stored bounds
    Box space_;
    vec3 centre_{0};
    float reach_ = infinity;  ///< infinity: whatever overlaps is exact for every ray
    float radius_ = 0;
    float radius_per_distance_ = 0;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
