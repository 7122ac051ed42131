#include "accel/embree/scene.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA::embree {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// Primitives that Embree has a kind for, and the rest.
struct Sorted {
    Numbers triangles, spheres, others;

    explicit Sorted(const Geometry& geometry) {
        for (std::uint32_t i = 0; i < geometry.size(); ++i) {
            const PrimitiveRef& ref = geometry.ref(i);
            if (!is_native(ref)) others.push_back(i);
            else (ref.kind == PrimitiveKind::triangle ? triangles : spheres).push_back(i);
        }
    }
};

RTCSceneFlags flags(const Geometry& geometry) {
    return geometry.precision() == Precision::watertight ? RTC_SCENE_FLAG_ROBUST
                                                         : RTC_SCENE_FLAG_NONE;
}

}  // namespace

Scene::Scene(const Geometry& geometry, RTCBuildQuality quality)
    : geometry_(geometry), quality_(quality), scene_(rtcNewScene(device_.handle())) {
    const Sorted sorted(geometry);
    takes_near_end_ = geometry.precision() == Precision::watertight || !sorted.spheres.empty();
    rtcSetSceneFlags(handle(), flags(geometry));
    rtcSetSceneBuildQuality(handle(), quality);
    add_triangles(sorted.triangles);
    add_spheres(sorted.spheres);
    user_ = UserGeometry(geometry, sorted.others);
    add_others();
    same_numbers_ = attached_ == 1;  // its numbers ascend, and it has them all
    const std::int64_t before = device_.bytes();
    rtcCommitScene(handle());
    bytes_ = device_.bytes() - before + static_cast<std::int64_t>(user_.bytes());
    device_.require_success();
}

void Scene::attach(RTCGeometry geometry, const Numbers& numbers) {
    rtcSetGeometryMask(geometry, 0xffffffff);
    // A scene of low quality builds each geometry by that one's own quality, which is not its own.
    if (quality_ == RTC_BUILD_QUALITY_LOW) rtcSetGeometryBuildQuality(geometry, quality_);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(handle(), geometry, attached_);
    rtcReleaseGeometry(geometry);
    first_[attached_++] = numbers_.size();
    numbers_.insert(numbers_.end(), numbers.begin(), numbers.end());
}

void Scene::add_triangles(const Numbers& numbers) {
    if (numbers.empty()) return;
    const auto vertices = geometry_.vertices();
    const auto triangles = geometry_.triangles();
    RTCGeometry mesh = rtcNewGeometry(device_.handle(), RTC_GEOMETRY_TYPE_TRIANGLE);
    // A copy: Embree reads 16 bytes from each vertex, so the last one needs padding.
    void* positions = rtcSetNewGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                              sizeof(vec3), vertices.size());
    if (positions != nullptr)
        std::copy(vertices.begin(), vertices.end(), static_cast<vec3*>(positions));
    constexpr std::size_t stride = sizeof(triangles[0]);
    if (numbers.size() == triangles.size()) {
        rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   triangles.data(), 0, stride, triangles.size());
    } else {
        auto* indices = static_cast<std::array<std::uint32_t, 3>*>(rtcSetNewGeometryBuffer(
            mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, stride, numbers.size()));
        if (indices != nullptr)
            for (std::uint32_t number : numbers)
                *indices++ = triangles[geometry_.ref(number).index];
    }
    attach(mesh, numbers);
}

void Scene::add_spheres(const Numbers& numbers) {
    if (numbers.empty()) return;
    RTCGeometry points = rtcNewGeometry(device_.handle(), RTC_GEOMETRY_TYPE_SPHERE_POINT);
    auto* spheres = static_cast<Sphere*>(rtcSetNewGeometryBuffer(
        points, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(Sphere), numbers.size()));
    static_assert(sizeof(Sphere) == 16);  // Embree's layout: centre, radius
    if (spheres != nullptr)
        for (std::uint32_t number : numbers)
            *spheres++ = geometry_.sphere(geometry_.ref(number).index);
    attach(points, numbers);
}

void Scene::add_others() {
    if (user_.size() == 0) return;
    attach(user_.create(device_.handle()), user_.numbers());
}

}  // namespace rayshoot::inline RAYSHOOT_ISA::embree
