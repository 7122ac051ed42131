#pragma once

#include "accel/bsp/clipper.h"
#include "accel/bsp/general/frame.h"
#include "accel/bvh/reference.h"

#include <array>
#include <optional>

/// What a cell between oblique planes holds of a primitive.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Two statements about each hit of the primitive whose parameter is in the ray's interval of the
/// cell: the parameter is in that of `box`, and the point of the primitive that is nearest to the
/// hit is in the hull of `corners`.
struct Part {
    static constexpr std::uint32_t most_corners = 12;

    std::uint32_t number = no_primitive;
    std::uint32_t size = 0;  ///< of corners; 0: none are known, the box has to do
    Box box;
    std::array<dvec3, most_corners> corners;  ///< from the frame's centre

    Reference reference() const { return {box, number}; }
};

/// Heights above a plane.
struct Heights {
    double lo = 0, hi = 0;
};

/// Makes parts, and divides them.
class PartMaker {
public:
    PartMaker(const Geometry& geometry, const Membership& membership)
        : geometry_(&geometry), frame_(geometry, membership) {}

    const ObliqueFrame& frame() const { return frame_; }
    /// None: nothing is left in the reference's box.
    std::optional<Part> whole(const Reference& reference) const;
    Heights heights(const Part& part, const ObliquePlane& plane) const;
    bool is_below(const Heights& heights) const { return heights.lo <= frame_.margin; }
    bool is_above(const Heights& heights) const { return heights.hi >= -frame_.margin; }
    /// The part on one side; none: nothing is.
    std::optional<Part> below(const Part& part, const ObliquePlane& plane) const;
    std::optional<Part> above(const Part& part, const ObliquePlane& plane) const;
    /// The part in a box, whose primitive's own part there is `clipped`.
    std::optional<Part> within(Part part, const Box& box, const Box& clipped) const;

private:
    void set_corners(Part& part) const;
    void fit_box(Part& part) const;

    const Geometry* geometry_;
    ObliqueFrame frame_;
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
