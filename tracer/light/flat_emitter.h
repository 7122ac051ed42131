#pragma once

#include <optional>
#include <vector>

#include "data/scene.h"
#include "tracer/light/clearance.h"
#include "tracer/sampling/pair.h"

namespace rayshoot {

/// A rectangle, a disc or a mesh of triangles, sampled uniformly by area. It shines to the side of
/// its normal.
class FlatEmitter {
public:
    FlatEmitter(const Scene& scene, const Light& light);

    std::optional<LightSample> sample(const dvec3& from, float time, Pair pair) const;
    float pdf(const dvec3& from, const SurfacePoint& at, float time) const;
    vec3 power(double) const;
    double area() const { return area_; }

private:
    struct Spot {
        dvec3 position, normal;  ///< unit
    };
    Spot on_light(Pair pair) const;
    Spot on_triangles(Pair pair) const;
    Spot in_world(const Spot& spot, float time) const;
    /// Per solid angle, seen over `distance` squared, at `cosine` with the normal.
    double density(double distance_squared, double cosine) const;

    const Light& light_;
    const Geometry& geometry_;
    const Motion* motion_ = nullptr;  ///< null: it rests
    Clearance clearance_;
    double area_ = 0;
    dvec3 normal_{0, 0, 1};           ///< rectangle and disc
    dvec3 across_{0}, down_{0};       ///< of a disc: two radii at right angles
    std::vector<double> cumulative_;  ///< triangles: area of this one and those before
};

}  // namespace rayshoot
