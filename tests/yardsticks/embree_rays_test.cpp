#include "accel/embree/embree.h"
#include "tests/yardsticks/oracle.h"
#include "tests/yardsticks/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

/// Single rays at the edges of what may be asked: intervals, origins, invalid rays.
namespace rayshoot::yardsticks {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

std::unique_ptr<Accel> embree(const Geometry& geometry) {
    return build({embree_entry()}, "embree", {geometry});
}

Geometry unit_sphere() {
    GeometryBuilder builder;
    builder.add_sphere({vec3{0}, 1});
    return std::move(builder).build();
}

/// A triangle across the z axis at z = 0.
Geometry one_triangle(Precision precision = Precision::standard) {
    GeometryBuilder builder;
    builder.add_triangle(vec3{-1, -1, 0}, vec3{1, -1, 0}, vec3{0, 1, 0});
    return std::move(builder).build(precision);
}

Ray down(float z, float t_min = 0, float t_max = infinity) {
    return {vec3{0, 0, z}, t_min, vec3{0, 0, -1}, t_max, 0};
}

/// One answer, the same on every path that the kinds of ray stand for, and the same to any-hit.
Hit answer(const Geometry& geometry, const Ray& ray) {
    const auto accel = embree(geometry);
    const Hit hit = closest(*accel, {ray}, RayKind::camera)[0];
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::secondary}) {
        EXPECT_EQ(closest(*accel, {ray}, kind)[0], hit);
        EXPECT_EQ(occluded(*accel, {ray}, kind)[0], hit.primitive != no_primitive);
    }
    return hit;
}

TEST(EmbreeRays, sphere_is_hit_from_outside_on_the_near_side) {
    EXPECT_NEAR(answer(unit_sphere(), down(3)).t, 2, 1e-5);
}
TEST(EmbreeRays, sphere_is_hit_from_inside) {
    EXPECT_NEAR(answer(unit_sphere(), down(0.5f)).t, 1.5, 1e-5);
}
TEST(EmbreeRays, sphere_is_hit_on_the_far_side_when_the_near_one_is_before_t_min) {
    EXPECT_NEAR(answer(unit_sphere(), down(3, 2.5f)).t, 4, 1e-5);
}

/// Embree's t of a ray at distance 1 is 1 but for its reciprocals' rounding, which differs with the
/// instruction set.
constexpr float t_rounding = 1e-5f;

TEST(EmbreeRays, triangle_is_hit_from_both_sides) {
    EXPECT_NEAR(answer(one_triangle(), down(1)).t, 1, t_rounding);
    const Ray up{vec3{0, 0, -1}, 0, vec3{0, 0, 1}, infinity, 0};
    EXPECT_NEAR(answer(one_triangle(), up).t, 1, t_rounding);
}

TEST(EmbreeRays, interval_ends_before_and_begins_behind_its_ends) {
    for (const Precision precision : {Precision::standard, Precision::watertight}) {
        const Geometry geometry = one_triangle(precision);
        EXPECT_EQ(answer(geometry, down(1, 0, 1 - t_rounding)), Hit{});
        EXPECT_EQ(answer(geometry, down(1, 1 + t_rounding, 2)), Hit{});
        EXPECT_NEAR(answer(geometry, down(1, 0.5f, 1 + t_rounding)).t, 1, t_rounding);
        EXPECT_NEAR(answer(geometry, down(1, 1 - t_rounding, 2)).t, 1, t_rounding);
    }
}

TEST(EmbreeRays, origin_on_the_surface_does_not_hit_it) {
    EXPECT_EQ(answer(one_triangle(), down(0)), Hit{});
    EXPECT_EQ(answer(one_triangle(Precision::watertight), down(0)), Hit{});
    EXPECT_NEAR(answer(unit_sphere(), down(1)).t, 2, 1e-5);
}

TEST(EmbreeRays, t_is_in_units_of_the_direction) {
    Ray ray = down(1);
    ray.direction = {0, 0, -0.25f};
    EXPECT_NEAR(answer(one_triangle(), ray).t, 4, 4 * t_rounding);
}

TEST(EmbreeRays, negative_t_min_looks_behind_the_origin) {
    const Geometry geometry = one_triangle();
    EXPECT_NEAR(answer(geometry, down(-1, -3)).t, -1, 1e-5);
    EXPECT_NEAR(answer(geometry, down(-1, -infinity)).t, -1, 1e-5);
    EXPECT_NEAR(answer(geometry, down(1, -3)).t, 1, 1e-5);
    EXPECT_EQ(answer(geometry, down(-1, -0.5f)), Hit{});
    EXPECT_EQ(answer(geometry, down(-1, -3, -2)), Hit{});
}

TEST(EmbreeRays, invalid_rays_are_misses_and_leave_their_neighbours_alone) {
    const Geometry geometry = one_triangle();
    const auto accel = embree(geometry);
    std::vector<Ray> rays(40, down(1));
    rays[1].origin.x = nan;
    rays[3].origin.y = infinity;
    rays[5].direction.z = -infinity;
    rays[7].direction = vec3{0};
    rays[9].t_min = nan;
    rays[11].t_max = nan;
    rays[13].t_min = 2, rays[13].t_max = 1;
    rays[15].t_max = 0;
    rays[17].t_min = infinity;
    rays[19].time = nan;
    rays[21].t_max = -infinity;
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::secondary}) {
        const std::vector<Hit> hits = closest(*accel, rays, kind);
        const std::vector<std::uint8_t> any = occluded(*accel, rays, kind);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (answerable(rays[i])) EXPECT_NEAR(hits[i].t, 1, t_rounding) << i;
            else EXPECT_EQ(hits[i], Hit{}) << i;
            EXPECT_EQ(any[i], answerable(rays[i])) << i;
        }
    }
}

TEST(EmbreeRays, invalid_rays_are_misses_of_spheres_and_user_geometry_too) {
    const Geometry geometry = everything(60);
    const auto accel = embree(geometry);
    for (std::size_t i = 0; i < 9; ++i) {
        std::vector<Ray> rays = inward_rays(64, 4, 1);
        for (Ray& ray : rays) {
            float* const fields[] = {&ray.origin.x,    &ray.origin.y,    &ray.origin.z,
                                     &ray.t_min,       &ray.direction.x, &ray.direction.y,
                                     &ray.direction.z, &ray.t_max,       &ray.time};
            *fields[i] = nan;
        }
        for (const Hit& hit : closest(*accel, rays, RayKind::secondary)) EXPECT_EQ(hit, Hit{});
        for (const std::uint8_t any : occluded(*accel, rays, RayKind::secondary)) EXPECT_EQ(any, 0);
    }
}

TEST(EmbreeRays, times_outside_the_shutter_are_clamped) {
    const Geometry geometry = everything(60);
    const auto accel = embree(geometry);
    std::vector<Ray> inside = inward_rays(500, 4, 1), outside = inside;
    for (std::size_t i = 0; i < inside.size(); ++i) {
        inside[i].time = i % 2 == 0 ? 0.0f : 1.0f;
        outside[i].time = i % 2 == 0 ? -3.0f : 7.0f;
    }
    EXPECT_EQ(closest(*accel, inside, RayKind::camera), closest(*accel, outside, RayKind::camera));
}

TEST(EmbreeRays, movers_are_where_they_are_at_the_ray_s_time) {
    GeometryBuilder builder;
    Motion motion;
    motion.translation[1] = vec3{0, 0, -2};
    builder.add_triangle(vec3{-1, -1, 0}, vec3{1, -1, 0}, vec3{0, 1, 0},
                         builder.add_motion(motion));
    const Geometry geometry = std::move(builder).build();
    for (const float time : {0.0f, 0.5f, 1.0f}) {
        Ray ray = down(1);
        ray.time = time;
        EXPECT_NEAR(answer(geometry, ray).t, 1 + 2 * time, 1e-5);
    }
}

}  // namespace
}  // namespace rayshoot::yardsticks
