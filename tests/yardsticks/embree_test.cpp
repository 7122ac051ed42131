#include "accel/embree/embree.h"

#include "accel/embree/device.h"
#include "accel/embree/scene.h"
#include "tests/yardsticks/oracle.h"
#include "tests/yardsticks/scenes.h"

#include <gtest/gtest.h>

#include <future>

namespace rayshoot::yardsticks {
namespace {

const std::vector<std::string> specs {
    "embree", "embree:kernel=single", "embree:kernel=packet",
#if RTC_VERSION_MAJOR < 4
        "embree:kernel=stream",
#endif
        "embree:quality=low", "embree:quality=high",
};
constexpr RayKind kinds[] = {RayKind::camera, RayKind::shadow, RayKind::secondary};

std::unique_ptr<Accel> embree(const Geometry& geometry, std::string_view spec = "embree") {
    return build({embree_entry()}, spec, {geometry});
}

/// Every spec and kind of ray: the nearest hits are brute force's, and any-hit says the same.
void expect_agreement(const Geometry& geometry, const std::vector<Ray>& rays, float tolerance) {
    for (const std::string& spec : specs) {
        const auto accel = embree(geometry, spec);
        for (const RayKind kind : kinds) {
            SCOPED_TRACE(spec + ", kind " + std::to_string(static_cast<int>(kind)));
            const std::vector<Hit> hits = closest(*accel, rays, kind);
            const Comparison comparison = compare(geometry, rays, hits, tolerance);
            EXPECT_EQ(comparison.differences, 0u) << comparison.first;
            EXPECT_GT(comparison.hits, rays.size() / 20);
            EXPECT_LE(comparison.ambiguous, rays.size() / 100);
            const std::vector<std::uint8_t> any = occluded(*accel, rays, kind);
            std::size_t unlike = 0;
            for (std::size_t i = 0; i < rays.size(); ++i)
                unlike += any[i] != (hits[i].primitive != no_primitive);
            EXPECT_LE(unlike, comparison.ambiguous);
        }
    }
}

TEST(Embree, agrees_on_triangles) {
    expect_agreement(triangle_soup(200), inward_rays(3000, 4, 1), 1e-4f);
}
TEST(Embree, agrees_on_watertight_triangles) {
    expect_agreement(triangle_soup(200, Precision::watertight), inward_rays(3000, 4, 1), 1e-4f);
}
TEST(Embree, agrees_on_spheres) {
    expect_agreement(sphere_cloud(60), inward_rays(3000, 4, 1), 1e-3f);
}
TEST(Embree, agrees_on_frusta) {
    expect_agreement(frustum_pile(60), inward_rays(3000, 4, 1), 1e-5f);
}
TEST(Embree, agrees_on_concave_polygons) {
    expect_agreement(polygon_pile(100), inward_rays(3000, 4, 1), 1e-5f);
}
TEST(Embree, agrees_on_everything_at_once_and_moving) {
    expect_agreement(everything(120), inward_rays(3000, 4, 1), 1e-3f);
}
TEST(Embree, agrees_from_inside_the_scene) {
    expect_agreement(everything(120), inward_rays(3000, 0.3f, 1), 1e-3f);
}

TEST(Embree, knows_triangles_and_spheres_itself_and_nothing_else) {
    using embree::Scene;
    EXPECT_EQ(Scene(triangle_soup(10), RTC_BUILD_QUALITY_MEDIUM).user_primitives(), 0u);
    EXPECT_EQ(Scene(sphere_cloud(10), RTC_BUILD_QUALITY_MEDIUM).user_primitives(), 0u);
    EXPECT_EQ(Scene(frustum_pile(10), RTC_BUILD_QUALITY_MEDIUM).user_primitives(), 10u);
    // Of each dozen, six are frusta or polygons, and two more move.
    EXPECT_EQ(Scene(everything(12), RTC_BUILD_QUALITY_MEDIUM).user_primitives(), 8u);
}

TEST(Embree, remarks_how_many_primitives_are_not_its_own) {
    EXPECT_EQ(embree_remark(sphere_cloud(10)), "");
    EXPECT_EQ(embree_remark(everything(12)), "8 of 12 primitives by our own test");
}

TEST(Embree, reports_barycentrics_of_the_second_and_third_vertex) {
    GeometryBuilder builder;
    builder.add_triangle(vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 1, 0});
    const Geometry geometry = std::move(builder).build();
    const std::vector<Ray> rays{{vec3{0.25f, 0.5f, 2}, 0, vec3{0, 0, -1}, infinity, 0}};
    const Hit hit = closest(*embree(geometry), rays, RayKind::camera)[0];
    EXPECT_EQ(hit.primitive, 0u);
    EXPECT_NEAR(hit.t, 2, 1e-6);
    EXPECT_NEAR(hit.u, 0.25, 1e-6);
    EXPECT_NEAR(hit.v, 0.5, 1e-6);
}

TEST(Embree, sees_nothing_in_an_empty_scene) {
    const Geometry geometry = GeometryBuilder().build();
    const std::vector<Ray> rays = inward_rays(100, 4, 1);
    for (const std::string& spec : specs) {
        const auto accel = embree(geometry, spec);
        for (const Hit& hit : closest(*accel, rays, RayKind::camera)) EXPECT_EQ(hit, Hit{});
        for (const std::uint8_t any : occluded(*accel, rays, RayKind::shadow)) EXPECT_EQ(any, 0);
    }
}

TEST(Embree, passes_through_degenerate_triangles) {
    GeometryBuilder builder;
    builder.add_triangle(vec3{0}, vec3{0}, vec3{0});
    builder.add_triangle(vec3{-1, 0, 0}, vec3{0}, vec3{1, 0, 0});
    const std::uint32_t real =
        builder.add_triangle(vec3{-1, -1, -1}, vec3{1, -1, -1}, vec3{0, 1, -1});
    const Geometry geometry = std::move(builder).build();
    const std::vector<Ray> rays{{vec3{0, 0, 2}, 0, vec3{0, 0, -1}, infinity, 0}};
    EXPECT_EQ(closest(*embree(geometry), rays, RayKind::camera)[0].primitive, real);
}

TEST(Embree, answers_alike_every_time_and_in_every_batch_size) {
    const Geometry geometry = everything(120);
    const std::vector<Ray> rays = inward_rays(5000, 4, 1);
    for (const std::string& spec : specs) {
        const auto accel = embree(geometry, spec), again = embree(geometry, spec);
        const std::vector<Hit> hits = closest(*accel, rays, RayKind::camera, 4096);
        EXPECT_EQ(hits, closest(*again, rays, RayKind::camera, 4096)) << spec;
        const Comparison one =
            compare(geometry, rays, closest(*accel, rays, RayKind::camera, 1), 1e-3f);
        EXPECT_EQ(one.differences, 0u) << spec << one.first;
    }
}

TEST(Embree, sessions_on_two_threads_do_not_disturb_each_other) {
    const Geometry geometry = everything(120);
    const std::vector<Ray> rays = inward_rays(5000, 4, 1);
    const auto accel = embree(geometry);
    const std::vector<Hit> alone = closest(*accel, rays, RayKind::camera);
    const auto lane = [&] { return closest(*accel, rays, RayKind::camera); };
    auto first = std::async(std::launch::async, lane),
         second = std::async(std::launch::async, lane);
    EXPECT_EQ(first.get(), alone);
    EXPECT_EQ(second.get(), alone);
}

TEST(Embree, refuses_coordinates_that_it_would_leave_out) {
    GeometryBuilder builder;
    builder.add_triangle(vec3{0}, vec3{2e18f, 0, 0}, vec3{0, 1, 0});
    EXPECT_NE(embree_entry().refuses(std::move(builder).build()), "");
    EXPECT_EQ(embree_entry().refuses(triangle_soup(3)), "");
    EXPECT_EQ(embree_entry().refuses(GeometryBuilder().build()), "");
}

TEST(Embree, refuses_unknown_options_with_what_exists) {
    const Geometry geometry = triangle_soup(3);
    EXPECT_THROW(embree(geometry, "embree:kernel=fastest"), std::invalid_argument);
    EXPECT_THROW(embree(geometry, "embree:threads=2"), std::invalid_argument);
    EXPECT_THROW(embree(geometry, "embree:quality=best"), std::invalid_argument);
}

TEST(Embree, counts_nothing_and_says_so) {
    const Geometry geometry = triangle_soup(3);
    const auto accel = embree(geometry);
    EXPECT_EQ(accel->open(Mode::counting)->counters(RayKind::camera), nullptr);
    EXPECT_FALSE(accel->footprint().interior.has_value());
    EXPECT_GT(accel->footprint().bytes.value_or(0), 0u);
    EXPECT_EQ(accel->spec(), "embree");
}

TEST(Embree, runs_with_our_instruction_set) {
    embree::Device device;
    EXPECT_EQ(
        rtcGetDeviceProperty(device.handle(), RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0,
        embree::packet_width == 16);
    EXPECT_NE(embree_description().find("ours: "), std::string::npos);
}

}  // namespace
}  // namespace rayshoot::yardsticks
