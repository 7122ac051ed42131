#pragma once

#include "accel/core/geometry.h"
#include "accel/embree/device.h"
#include "accel/embree/user_geometry.h"

#include <array>
#include <vector>

/// Our geometry as a committed Embree scene: static triangles and spheres natively, everything else
/// as user geometry through our own test.
namespace rayshoot::inline RAYSHOOT_ISA::embree {

/// Whether Embree has a kind of its own for a primitive.
inline bool is_native(const PrimitiveRef& ref) {
    return ref.motion == no_motion &&
           (ref.kind == PrimitiveKind::triangle || ref.kind == PrimitiveKind::sphere);
}

class Scene {
public:
    /// Refers to `geometry`. Throws std::runtime_error when Embree fails.
    Scene(const Geometry& geometry, RTCBuildQuality quality);
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    RTCScene handle() const { return scene_.get(); }
    const Geometry& geometry() const { return geometry_; }
    /// Our number of a primitive.
    std::uint32_t primitive(unsigned geometry_id, unsigned primitive_id) const {
        return numbers_[first_[geometry_id] + primitive_id];
    }
    /// Whether that is primitive_id itself.
    bool same_numbers() const { return same_numbers_; }
    /// Whether Embree's tests for this scene take t == tnear as a hit: those of the robust mode and
    /// of spheres do, Moeller-Trumbore does not.
    bool takes_near_end() const { return takes_near_end_; }
    /// Bytes of the hierarchy, without the mesh buffers that it was built from.
    std::int64_t bytes() const { return bytes_; }
    /// Primitives that Embree does not know and our own test answers for.
    std::size_t user_primitives() const { return user_.size(); }
    std::string description() const { return device_.description(); }

private:
    struct Release {
        void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
    };

    void add_triangles(const std::vector<std::uint32_t>& numbers);
    void add_spheres(const std::vector<std::uint32_t>& numbers);
    void add_others();
    void attach(RTCGeometry geometry, const std::vector<std::uint32_t>& numbers);

    const Geometry& geometry_;
    const RTCBuildQuality quality_;
    Device device_;
    UserGeometry user_;
    std::unique_ptr<std::remove_pointer_t<RTCScene>, Release> scene_;
    bool same_numbers_ = false;
    bool takes_near_end_;
    std::int64_t bytes_ = 0;
    std::vector<std::uint32_t> numbers_;  ///< ours, by Embree geometry
    std::array<std::size_t, 3> first_{};  ///< of each Embree geometry, in numbers_
    unsigned attached_ = 0;
};

/// What Embree leaves out of its hierarchy without a word: coordinates beyond this.
inline constexpr float largest_coordinate = 1.844e18f;

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
