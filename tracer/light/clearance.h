#pragma once

#include <cstdint>
#include <span>

#include "accel/core/geometry.h"
#include "tracer/light/light_sample.h"

/// Where a shadow ray must end so that it does not meet the light that it asks for.
namespace rayshoot {

/// The error of tests of the light's primitives, and so how far off them a ray's end is safe. A
/// light without primitives needs none. README.md derives the factors.
class Clearance {
public:
    Clearance() = default;
    Clearance(const Geometry& geometry, std::span<const std::uint32_t> primitives);

    /// How far off the light its primitives' tests, and SurfacePoint, may place a point of it.
    double at(const dvec3& position) const { return fixed_ + by_position_ * taxicab(position); }
    /// Sets point and end of `sample` to those of a ray from `from` to the light's point `position`
    /// of unit normal `normal`, turned to `from`.
    void end(LightSample& sample, const dvec3& from, const dvec3& position,
             const dvec3& normal) const;

private:
    bool exists_ = false;     ///< anything to keep clear of
    double fixed_ = 0;        ///< scene units
    double by_distance_ = 0;  ///< times the taxicab distance travelled
    double by_position_ = 0;  ///< times the taxicab length of the position
};

}  // namespace rayshoot
