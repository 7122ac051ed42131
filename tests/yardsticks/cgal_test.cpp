#include "accel/cgal/cgal.h"

#include "tests/yardsticks/oracle.h"
#include "tests/yardsticks/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <future>

namespace rayshoot::yardsticks {
namespace {

std::unique_ptr<Accel> cgal(const Geometry& geometry) {
    return build({cgal_entry()}, "cgal", {geometry});
}

Geometry one_triangle() {
    GeometryBuilder builder;
    builder.add_triangle(vec3{-1, -1, 0}, vec3{1, -1, 0}, vec3{0, 1, 0});
    return std::move(builder).build();
}

Ray down(float z, float t_min = 0, float t_max = infinity) {
    return {vec3{0, 0, z}, t_min, vec3{0, 0, -1}, t_max, 0};
}

Hit answer(const Geometry& geometry, const Ray& ray) {
    const auto accel = cgal(geometry);
    const Hit hit = closest(*accel, {ray}, RayKind::camera)[0];
    EXPECT_EQ(occluded(*accel, {ray}, RayKind::shadow)[0], hit.primitive != no_primitive);
    return hit;
}

void expect_agreement(const Geometry& geometry, const std::vector<Ray>& rays) {
    const auto accel = cgal(geometry);
    const std::vector<Hit> hits = closest(*accel, rays, RayKind::secondary);
    const Comparison comparison = compare(geometry, rays, hits, 1e-5f);
    EXPECT_EQ(comparison.differences, 0u) << comparison.first;
    EXPECT_GT(comparison.hits, rays.size() / 20);
    EXPECT_LE(comparison.ambiguous, rays.size() / 100);
    const std::vector<std::uint8_t> any = occluded(*accel, rays, RayKind::secondary);
    for (std::size_t i = 0; i < rays.size(); ++i)
        EXPECT_EQ(any[i], hits[i].primitive != no_primitive) << i;
}

TEST(Cgal, agrees_on_a_soup) { expect_agreement(triangle_soup(200), inward_rays(3000, 4, 1)); }
TEST(Cgal, agrees_on_a_closed_surface) { expect_agreement(bumpy_ball(6), inward_rays(3000, 4, 1)); }
TEST(Cgal, agrees_from_inside) { expect_agreement(triangle_soup(200), inward_rays(3000, 0.3f, 1)); }
TEST(Cgal, agrees_from_far_away) { expect_agreement(bumpy_ball(6), inward_rays(1000, 1e3f, 1)); }

TEST(Cgal, reports_barycentrics_of_the_second_and_third_vertex) {
    GeometryBuilder builder;
    builder.add_triangle(vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{0, 1, 0});
    const Ray ray{vec3{0.25f, 0.5f, 2}, 0, vec3{0, 0, -1}, infinity, 0};
    const Hit hit = answer(std::move(builder).build(), ray);
    EXPECT_EQ(hit.primitive, 0u);
    EXPECT_NEAR(hit.u, 0.25, 1e-6);
    EXPECT_NEAR(hit.v, 0.5, 1e-6);
}

TEST(Cgal, interval_is_open_at_both_ends) {
    EXPECT_EQ(answer(one_triangle(), down(1, 0, 1)), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(1, 1, 2)), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(1, 0.5f, std::nextafter(1.0f, 2.0f))).t, 1);
    EXPECT_EQ(answer(one_triangle(), down(0)), Hit{});
}

TEST(Cgal, negative_t_min_looks_behind_the_origin) {
    EXPECT_EQ(answer(one_triangle(), down(-1, -3)).t, -1);
    EXPECT_EQ(answer(one_triangle(), down(-1, -infinity)).t, -1);
    EXPECT_EQ(answer(one_triangle(), down(-1, -0.5f)), Hit{});
}

TEST(Cgal, invalid_rays_are_misses) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Ray ray = down(1);
    ray.direction = vec3{0};
    EXPECT_EQ(answer(one_triangle(), ray), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(nan)), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(infinity)), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(1, nan)), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(1, 0, nan)), Hit{});
    EXPECT_EQ(answer(one_triangle(), down(1, 2, 1)), Hit{});
}

TEST(Cgal, leaves_out_degenerate_triangles_and_keeps_our_numbers) {
    GeometryBuilder builder;
    builder.add_triangle(vec3{0}, vec3{0}, vec3{0});
    builder.add_triangle(vec3{-1, 0, 0}, vec3{0}, vec3{1, 0, 0});
    const std::uint32_t real =
        builder.add_triangle(vec3{-1, -1, -1}, vec3{1, -1, -1}, vec3{0, 1, -1});
    EXPECT_EQ(answer(std::move(builder).build(), down(2)).primitive, real);
}

TEST(Cgal, sees_nothing_in_an_empty_scene) {
    EXPECT_EQ(answer(GeometryBuilder().build(), down(1)), Hit{});
}

TEST(Cgal, sessions_on_two_threads_do_not_disturb_each_other) {
    const Geometry geometry = triangle_soup(200);
    const std::vector<Ray> rays = inward_rays(3000, 4, 1);
    const auto accel = cgal(geometry);
    const std::vector<Hit> alone = closest(*accel, rays, RayKind::camera);
    const auto lane = [&] { return closest(*accel, rays, RayKind::camera); };
    auto first = std::async(std::launch::async, lane),
         second = std::async(std::launch::async, lane);
    EXPECT_EQ(first.get(), alone);
    EXPECT_EQ(second.get(), alone);
}

TEST(Cgal, refuses_scenes_that_are_not_triangles_with_a_reason) {
    for (const Geometry& geometry : {sphere_cloud(3), everything(12), polygon_pile(3)}) {
        EXPECT_NE(cgal_entry().refuses(geometry), "");
        EXPECT_THROW(cgal(geometry), std::invalid_argument);
    }
    EXPECT_EQ(cgal_entry().refuses(triangle_soup(3)), "");
}

TEST(Cgal, counts_nothing_and_names_its_licence) {
    const Geometry geometry = triangle_soup(3);
    EXPECT_EQ(cgal(geometry)->open(Mode::counting)->counters(RayKind::camera), nullptr);
    EXPECT_NE(cgal_description().find("GPL-3"), std::string::npos);
}

}  // namespace
}  // namespace rayshoot::yardsticks
