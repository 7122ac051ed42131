#include <algorithm>

#include "accel/core/geometry.h"
#include "accel/core/primitive/padding.h"
#include "accel/core/primitive/rounding.h"

/// How far a reported point can lie from its primitive. Every constant is derived in README.md,
/// section "The error radius", where D is `distance` and h is `half_diagonal`.
namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr double unit = 0x1p-24;  ///< half a unit in the last place of a float in [1, 2)

struct Sizes {
    double distance;       ///< from an origin to the farthest point of the scene
    double half_diagonal;  ///< of the scene bounds
};

double radius_of(PrimitiveKind kind, Precision precision, const Sizes& sizes) {
    const auto [distance, half_diagonal] = sizes;
    switch (kind) {
        case PrimitiveKind::triangle:
            if (precision == Precision::watertight)
                return unit * (7 * distance + 3 * half_diagonal);
            return unit / double(float_parallel) * (48 * distance + 15 * half_diagonal);
        case PrimitiveKind::sphere:
            return 48 * unit * distance;
        case PrimitiveKind::frustum:
            return unit * (1.5 * distance + 6 * half_diagonal);
        case PrimitiveKind::polygon:
            break;
    }
    return unit * 1.5 * distance;
}

/// Largest sum of coordinates that the motion of one primitive handles.
double moving_size(const Motion& motion, const Box& rest) {
    return 3 * double(largest_coordinate(rest)) + taxicab(dvec3(motion.pivot)) +
           std::max(taxicab(dvec3(motion.translation[0])), taxicab(dvec3(motion.translation[1])));
}

}  // namespace

float Geometry::error_radius(float reach) const {
    if (refs_.empty()) return 0;
    const double half_diagonal =
        0.5 * length(dvec3(scene_bounds_.hi) - dvec3(scene_bounds_.lo)) * (1 + 0x1p-50);
    const Sizes sizes{double(reach) + half_diagonal, half_diagonal};
    const auto counts = count_by_kind();
    double radius = 0;
    for (std::size_t kind = 0; kind < counts.size(); ++kind)
        if (counts[kind] > 0)
            radius =
                std::max(radius, radius_of(static_cast<PrimitiveKind>(kind), precision_, sizes));
    double moving = 0;
    for (const PrimitiveRef& ref : refs_)
        if (ref.motion != no_motion)
            moving = std::max(
                moving, 2 * sizes.distance + moving_size(motion(ref.motion), rest_bounds(ref)));
    // The last term lets whoever grows a box by this radius use the slab form on it.
    return rounded_up(radius + unit * moving + 4 * unit * sizes.distance);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
