#pragma once

#include "accel/core/leaves.h"
#include "accel/embree/rtc.h"

#include <vector>

/// Primitives that Embree has no kind for (frusta, polygons, Movers): it keeps their boxes, and
/// asks our shared test.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

class UserGeometry {
public:
    UserGeometry() = default;
    /// Refers to `geometry`.
    UserGeometry(const Geometry& geometry, std::vector<std::uint32_t> numbers);

    /// The Embree geometry; it refers to *this, which must not move from then on.
    RTCGeometry create(RTCDevice device) const;

    std::size_t size() const { return numbers_.size(); }
    const std::vector<std::uint32_t>& numbers() const { return numbers_; }
    std::size_t bytes() const { return leaves_.bytes(); }

private:
    static void bounds(const RTCBoundsFunctionArguments* arguments);
    static void closest(const RTCIntersectFunctionNArguments* arguments);
    static void occluded(const RTCOccludedFunctionNArguments* arguments);

    /// The hit of one of our primitives that lies in the ray's interval; no_primitive: none.
    template <Query Q>
    Hit hit(unsigned index, RTCRayN* rays, unsigned width, unsigned lane) const;

    const Geometry* geometry_ = nullptr;
    std::vector<std::uint32_t> numbers_;
    Leaves leaves_;  ///< each primitive a leaf of its own
};

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
