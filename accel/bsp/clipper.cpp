#include "accel/bsp/clipper.h"

#include "accel/core/primitive/padding.h"

#include <array>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// A triangle cut by six planes has nine corners at most.
struct Corners {
    std::array<vec3, 10> at;
    std::size_t size = 0;
};

/// Keeps the part where side * (x[axis] - plane) >= 0.
void cut(Corners& corners, int axis, float plane, float side) {
    Corners kept;
    vec3 from = corners.at[corners.size - 1];
    float from_depth = side * (from[axis] - plane);
    for (std::size_t i = 0; i < corners.size; ++i) {
        const vec3 to = corners.at[i];
        const float depth = side * (to[axis] - plane);
        if ((from_depth < 0) != (depth < 0)) {
            const float share = from_depth / (from_depth - depth);
            kept.at[kept.size] = along(from, share, to - from);
            kept.at[kept.size++][axis] = plane;
        }
        if (depth >= 0) kept.at[kept.size++] = to;
        from = to;
        from_depth = depth;
    }
    corners = kept;
}

}  // namespace

Clipper::Clipper(const Geometry& geometry, const Membership& membership)
    : geometry_(&geometry), membership_(&membership) {
    const float largest = geometry.size() > 0 ? largest_coordinate(geometry.bounds()) : 0;
    in_float_ = membership.overlap() == Overlap::exact && 0x1p-40f < largest && largest < 0x1p40f;
    grow_ = float_above(membership.radius() + 0x1p-17f * largest);
}

Box Clipper::clipped_triangle(std::uint32_t primitive, const Box& cell) const {
    const Triangle triangle = geometry_->triangle(geometry_->ref(primitive).index);
    const Box whole = bounds(triangle), wanted = cell.grown(grow_);
    Corners corners{{triangle.a, triangle.b, triangle.c}, 3};
    for (int axis = 0; axis < 3; ++axis) {
        if (whole.lo[axis] < wanted.lo[axis] && corners.size > 0)
            cut(corners, axis, wanted.lo[axis], 1);
        if (whole.hi[axis] > wanted.hi[axis] && corners.size > 0)
            cut(corners, axis, wanted.hi[axis], -1);
    }
    Box part;
    for (std::size_t i = 0; i < corners.size; ++i) part.include(corners.at[i]);
    if (part.empty()) return {};
    const Box inside = part.grown(grow_).intersection(geometry_->bounds(primitive));
    return inside.intersection(cell);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
