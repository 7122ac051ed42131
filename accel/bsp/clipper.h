#pragma once

#include "accel/space/membership.h"

/// The parts of primitives in cells, for those who ask for many.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Membership::clipped() in float for triangles that stand still: the part of a triangle in the
/// cell (Sutherland & Hodgman 1974), with all planes moved outward by the error radius and a margin
/// for the rounding here. Every point made here is off by at most 12 u (u = 2^-24) of the scene's
/// largest coordinate per plane, six planes at most: less than the margin of 128 u.
class Clipper {
public:
    Clipper(const Geometry& geometry, const Membership& membership);

    /// Encloses Membership::clipped(), less tightly by the margin.
    Box clipped(std::uint32_t primitive, const Box& cell) const {
        if (in_float_ && triangle(primitive)) return clipped_triangle(primitive, cell);
        return membership_->clipped(primitive, cell);
    }

private:
    bool triangle(std::uint32_t primitive) const {
        const PrimitiveRef& ref = geometry_->ref(primitive);
        return ref.kind == PrimitiveKind::triangle && ref.motion == no_motion;
    }
    Box clipped_triangle(std::uint32_t primitive, const Box& cell) const;

    const Geometry* geometry_;
    const Membership* membership_;
    bool in_float_;  ///< parts are asked for, and nothing overflows or underflows
    float grow_;     ///< the error radius and the margin
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
