#pragma once

#include "accel/core/geometry.h"
#include "bench/gate/difference.h"

/// How answers of structures with arithmetic of their own (Embree, CGAL) are compared with ours.
namespace rayshoot {

/// A hit agrees when its t does within this share of t, or within `ambiguous_shift`.
inline constexpr float t_tolerance = 1e-4f;
/// A ray is ambiguous when moving it by this share of the largest coordinate in play makes the
/// reference give the other answer too: it grazes an edge, or has a second hit next to the first.
/// A hundred times the rounding of a float product there, a hundredth of a small triangle.
inline constexpr float ambiguous_shift = 1e-5f;
/// The largest share of rays that may differ without being ambiguous.
inline constexpr double unexplained_allowed = 1e-4;

struct ToleranceResult {
    std::size_t ambiguous = 0;  ///< differ, but the reference wavers there as well
    Differences unexplained;
};

/// `reference`: the structure that gave `expected`; asked again about the rays that differ.
/// `chosen`: as in exact_differences.
ToleranceResult tolerance_differences(const Accel& reference, const Geometry& geometry,
                                      const RayStream& stream, const StreamAnswers& expected,
                                      const StreamAnswers& found,
                                      const std::vector<std::size_t>& chosen = {});

}  // namespace rayshoot
