#include "accel/embree/user_geometry.h"

namespace rayshoot::inline RAYSHOOT_ISA::embree {
namespace {

std::vector<LeafRange> leaf_each(std::size_t count) {
    std::vector<LeafRange> leaves(count);
    for (std::uint32_t i = 0; i < count; ++i) leaves[i] = {i, 1};
    return leaves;
}

/// `t_max` is one float up: Embree's interval is closed, ours is open.
Ray ray_of(RTCRayN* rays, unsigned width, unsigned lane) {
    Ray ray;
    ray.origin = {RTCRayN_org_x(rays, width, lane), RTCRayN_org_y(rays, width, lane),
                  RTCRayN_org_z(rays, width, lane)};
    ray.direction = {RTCRayN_dir_x(rays, width, lane), RTCRayN_dir_y(rays, width, lane),
                     RTCRayN_dir_z(rays, width, lane)};
    ray.t_min = RTCRayN_tnear(rays, width, lane);
    ray.t_max = float_above(RTCRayN_tfar(rays, width, lane));
    ray.time = shutter_time(RTCRayN_time(rays, width, lane));
    return ray;
}

}  // namespace

UserGeometry::UserGeometry(const Geometry& geometry, std::vector<std::uint32_t> numbers)
    : geometry_(&geometry),
      numbers_(std::move(numbers)),
      leaves_(geometry, numbers_, leaf_each(numbers_.size())) {}

RTCGeometry UserGeometry::create(RTCDevice device) const {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(numbers_.size()));
    // Embree's pointer is not const; the callbacks below only read.
    rtcSetGeometryUserData(geometry, const_cast<UserGeometry*>(this));
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* arguments) { bounds(arguments); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, closest);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    return geometry;
}

void UserGeometry::bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto& self = *static_cast<const UserGeometry*>(arguments->geometryUserPtr);
    const Box& box = self.geometry_->bounds(self.numbers_[arguments->primID]);
    *arguments->bounds_o = {box.lo.x, box.lo.y, box.lo.z, 0, box.hi.x, box.hi.y, box.hi.z, 0};
}

template <Query Q>
Hit UserGeometry::hit(unsigned index, RTCRayN* rays, unsigned width, unsigned lane) const {
    const Ray ray = ray_of(rays, width, lane);
    if (!answerable(ray)) return {};
    Hit hit = nothing_yet(ray);
    const Silent count;
    leaves_.test<Q>({index, 1}, leaves_.prepared(ray), hit, count);
    return hit;
}

void UserGeometry::closest(const RTCIntersectFunctionNArguments* arguments) {
    const auto& self = *static_cast<const UserGeometry*>(arguments->geometryUserPtr);
    const unsigned width = arguments->N;
    RTCRayN* rays = RTCRayHitN_RayN(arguments->rayhit, width);
    RTCHitN* hits = RTCRayHitN_HitN(arguments->rayhit, width);
    for (unsigned lane = 0; lane < width; ++lane) {
        if (arguments->valid[lane] == 0) continue;
        const Hit hit = self.hit<Query::closest>(arguments->primID, rays, width, lane);
        if (hit.primitive == no_primitive) continue;
        RTCRayN_tfar(rays, width, lane) = hit.t;
        RTCHitN_u(hits, width, lane) = hit.u;
        RTCHitN_v(hits, width, lane) = hit.v;
        RTCHitN_primID(hits, width, lane) = arguments->primID;
        RTCHitN_geomID(hits, width, lane) = arguments->geomID;
    }
}

void UserGeometry::occluded(const RTCOccludedFunctionNArguments* arguments) {
    const auto& self = *static_cast<const UserGeometry*>(arguments->geometryUserPtr);
    const unsigned width = arguments->N;
    for (unsigned lane = 0; lane < width; ++lane) {
        if (arguments->valid[lane] == 0) continue;
        if (self.hit<Query::occluded>(arguments->primID, arguments->ray, width, lane).primitive !=
            no_primitive)
            RTCRayN_tfar(arguments->ray, width, lane) = -infinity;
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
