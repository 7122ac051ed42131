#include "accel/bsp/general/part.h"

#include "accel/core/primitive/rounding.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Keeps the part where dot(normal, x) <= most (Sutherland & Hodgman 1974), or all of it where that
/// has too many corners. False where nothing is left.
bool cut(Part& part, const dvec3& normal, double most) {
    std::array<dvec3, 2 * Part::most_corners> kept;
    std::uint32_t size = 0;
    dvec3 from = part.corners[part.size - 1];
    double from_height = dot(normal, from) - most;
    for (std::uint32_t i = 0; i < part.size; ++i) {
        const dvec3 to = part.corners[i];
        const double height = dot(normal, to) - most;
        if ((from_height > 0) != (height > 0))
            kept[size++] = along(from, from_height / (from_height - height), to - from);
        if (height <= 0) kept[size++] = to;
        from = to;
        from_height = height;
    }
    if (size > Part::most_corners) return true;
    std::copy_n(kept.begin(), size, part.corners.begin());
    part.size = size;
    return size > 0;
}

Heights heights_of_corners(const Part& part, const ObliquePlane& plane) {
    Heights heights{infinity, -infinity};
    for (std::uint32_t i = 0; i < part.size; ++i) {
        const double height = plane.height(part.corners[i]);
        heights = {std::min(heights.lo, height), std::max(heights.hi, height)};
    }
    return heights;
}

}  // namespace

void PartMaker::set_corners(Part& part) const {
    const PrimitiveRef& ref = geometry_->ref(part.number);
    if (ref.motion != no_motion) return;
    const auto add = [&](const dvec3& corner) {
        part.corners[part.size++] = corner - dvec3(frame_.centre);
    };
    if (ref.kind == PrimitiveKind::triangle) {
        const Triangle triangle = geometry_->triangle(ref.index);
        for (const vec3& corner : {triangle.a, triangle.b, triangle.c}) add(dvec3(corner));
    } else if (ref.kind == PrimitiveKind::polygon) {
        const Polygon& polygon = geometry_->polygon(ref.index);
        if (polygon.corners.size() > Part::most_corners || polygon.normal == dvec3(0)) return;
        for (const vec3& corner : polygon.corners) add(flattened(polygon, corner));
    }
}

/// To the corners, with all that may be reported as hit there.
void PartMaker::fit_box(Part& part) const {
    if (part.size == 0) return;
    Box around;
    for (std::uint32_t i = 0; i < part.size; ++i) {
        const dvec3 corner = part.corners[i] + dvec3(frame_.centre);
        around.include(
            vec3(rounded_down(corner.x), rounded_down(corner.y), rounded_down(corner.z)));
        around.include(vec3(rounded_up(corner.x), rounded_up(corner.y), rounded_up(corner.z)));
    }
    part.box = part.box.intersection(around.grown(rounded_up(frame_.margin)));
}

std::optional<Part> PartMaker::whole(const Reference& reference) const {
    Part part;
    part.number = reference.number;
    part.box = reference.bounds().box();
    set_corners(part);
    return within(part, part.box, part.box);
}

std::optional<Part> PartMaker::within(Part part, const Box& box, const Box& clipped) const {
    const dvec3 lo = frame_.local(box.lo), hi = frame_.local(box.hi);
    for (int axis = 0; axis < 3 && part.size > 0; ++axis) {
        dvec3 up(0);
        up[axis] = 1;
        if (!cut(part, up, hi[axis] + frame_.margin)) return {};
        if (!cut(part, -up, frame_.margin - lo[axis])) return {};
    }
    part.box = part.box.intersection(clipped).intersection(box);
    fit_box(part);
    if (part.box.empty()) return {};
    return part;
}

Heights PartMaker::heights(const Part& part, const ObliquePlane& plane) const {
    if (part.size > 0) return heights_of_corners(part, plane);
    const dvec3 lo = frame_.local(part.box.lo), hi = frame_.local(part.box.hi);
    Heights heights{-double(plane.offset), -double(plane.offset)};
    for (int axis = 0; axis < 3; ++axis) {
        const double n = plane.normal[axis];
        heights.lo += n < 0 ? n * hi[axis] : n * lo[axis];
        heights.hi += n < 0 ? n * lo[axis] : n * hi[axis];
    }
    if (geometry_->ref(part.number).motion != no_motion) return heights;
    const double shift = dot(dvec3(plane.normal), dvec3(frame_.centre)) + double(plane.offset);
    heights.hi =
        std::min(heights.hi, double(geometry_->support(part.number, plane.normal)) - shift);
    heights.lo =
        std::max(heights.lo, -double(geometry_->support(part.number, -plane.normal)) - shift);
    return heights;
}

std::optional<Part> PartMaker::below(const Part& part, const ObliquePlane& plane) const {
    Part half = part;
    if (half.size == 0) return half;
    if (!cut(half, dvec3(plane.normal), double(plane.offset) + frame_.margin)) return {};
    fit_box(half);
    if (half.box.empty()) return {};
    return half;
}

std::optional<Part> PartMaker::above(const Part& part, const ObliquePlane& plane) const {
    return below(part, {-plane.normal, -plane.offset});
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
