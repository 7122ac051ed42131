#include "tracer/light/clearance.h"

#include <algorithm>

#include "tracer/surface.h"

namespace rayshoot {
namespace {

constexpr double unit_roundoff = 0x1p-24;  // of float

/// Of spheres and polygons, whose tests see them off by 3u times the distance; and of the ray's own
/// rounding, u times it.
constexpr double distance_factor = 8 * unit_roundoff;
/// Of triangles, times (product of the taxicab edges) / area vector: both t's numerator and its
/// determinant are off by 6u of that.
constexpr double triangle_distance_factor = 12 * unit_roundoff;
constexpr double position_factor = 2 * unit_roundoff;
constexpr double moving_position_factor = 32 * unit_roundoff;
/// Half of what a shadow ray may miss its light's samples by (accel/core/promise.h).
constexpr double largest_offset = 32 * unit_roundoff;  // of taxicab(from) + taxicab(position)
/// The float test of a triangle is left for one in double where it would be off by more than this:
/// 12u / float_parallel.
constexpr double largest_shortening = 0x1p-13;  // of the distance

/// How much worse than that of a square corner a triangle's test is.
double skewness(const Triangle& triangle) {
    const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
    const double area = length(cross(e1, e2));
    if (!(area > 0)) return 0;                        // never hit
    const double worst = 1 / double{float_parallel};  // from there on in double
    return std::min(taxicab(e1) * taxicab(e2) / area, worst);
}

}  // namespace

Clearance::Clearance(const Geometry& geometry, std::span<const std::uint32_t> primitives)
    : exists_(!primitives.empty()) {
    for (const std::uint32_t primitive : primitives) {
        const PrimitiveRef& ref = geometry.ref(primitive);
        double by_distance = distance_factor;
        if (ref.kind == PrimitiveKind::triangle)
            by_distance += triangle_distance_factor * skewness(geometry.triangle(ref.index));
        const bool moves = ref.motion != no_motion;
        fixed_ = std::max(fixed_, resting_error(geometry, primitive));
        by_distance_ = std::max(by_distance_, by_distance);
        by_position_ = std::max(by_position_, moves ? moving_position_factor : position_factor);
    }
}

void Clearance::end(LightSample& sample, const dvec3& from, const dvec3& position,
                    const dvec3& normal) const {
    sample.point = position;
    if (!exists_) return;
    const dvec3 travelled = position - from;
    const double error = at(position) + by_distance_ * taxicab(travelled);
    const double offset = std::min(error, largest_offset * (taxicab(from) + taxicab(position)));
    sample.point = position + normal * offset;
    const double height = -dot(travelled, normal);
    const double shortening = height > 0 ? (error - offset) / height : 1;
    sample.end = just_before - static_cast<float>(std::min(shortening, largest_shortening));
}

}  // namespace rayshoot
