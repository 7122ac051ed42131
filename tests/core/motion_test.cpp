#include <gtest/gtest.h>

#include "accel/core/primitive/padding.h"
#include "tests/core/motions.h"
#include "tests/core/shapes.h"

namespace rayshoot {
namespace {

Ray ray_of(cases::Random& random) {
    Ray ray;
    ray.origin = random.in_cube(4);
    ray.direction = vec3(random.magnitude(-4, 4) * random.unit());
    ray.t_min = -3;
    ray.t_max = 7;
    ray.time = static_cast<float>(random.uniform(0, 1));
    return ray;
}

TEST(Motion, rest_frame_undoes_the_movement_and_keeps_t) {
    cases::Random random(81);
    for (int i = 0; i < 5000; ++i) {
        const Motion m = cases::motion(random);
        const Ray ray = ray_of(random), rest = into_rest_frame(m, ray);
        EXPECT_EQ(rest.t_min, ray.t_min);
        EXPECT_EQ(rest.t_max, ray.t_max);
        EXPECT_EQ(rest.time, ray.time);
        const double t = random.uniform(-2, 2);
        const dvec3 there = dvec3(rest.origin) + t * dvec3(rest.direction);
        const dvec3 back = cases::moved(m, ray.time, there);
        const dvec3 wanted = dvec3(ray.origin) + t * dvec3(ray.direction);
        EXPECT_LT(length(back - wanted),
                  0x1p-21 * (10 + std::abs(t) * length(dvec3(ray.direction))));
    }
}

TEST(Motion, identity_changes_no_bit) {
    cases::Random random(82);
    for (int i = 0; i < 1000; ++i) {
        const Ray ray = ray_of(random), rest = into_rest_frame(Motion{}, ray);
        EXPECT_EQ(rest.origin, ray.origin);
        EXPECT_EQ(rest.direction, ray.direction);
    }
}

TEST(Motion, time_is_clamped_to_the_shutter) {
    cases::Random random(83);
    for (int i = 0; i < 100; ++i) {
        const Motion m = cases::motion(random);
        Ray ray = ray_of(random), late = ray, early = ray;
        ray.time = 1;
        late.time = 2.5f;
        EXPECT_EQ(into_rest_frame(m, ray).origin, into_rest_frame(m, late).origin);
        ray.time = 0;
        early.time = -1;
        EXPECT_EQ(into_rest_frame(m, ray).direction, into_rest_frame(m, early).direction);
    }
}

TEST(Motion, directions_turn_with_the_frame) {
    cases::Random random(84);
    for (int i = 0; i < 2000; ++i) {
        const Motion m = cases::motion(random);
        const auto time = static_cast<float>(random.uniform(0, 1));
        const vec3 direction(random.unit());
        const dvec3 wanted = cases::moved(m, time, dvec3(m.pivot) + dvec3(direction)) -
                             cases::moved(m, time, dvec3(m.pivot));
        EXPECT_LT(length(dvec3(rotate_to_world(m, time, direction)) - wanted), 1e-6);
    }
}

TEST(Motion, swept_bounds_contain_the_whole_shutter_and_are_tight) {
    cases::Random random(85);
    for (int i = 0; i < 300; ++i) {
        const Motion m = cases::motion(random);
        Box rest;
        rest.include(random.in_cube(1));
        rest.include(random.in_cube(1));
        const Box all = swept(m, rest);
        Box sampled;
        for (int step = 0; step <= 2000; ++step) {
            for (int corner = 0; corner < 8; ++corner) {
                const dvec3 p(corner & 1 ? rest.hi.x : rest.lo.x,
                              corner & 2 ? rest.hi.y : rest.lo.y,
                              corner & 4 ? rest.hi.z : rest.lo.z);
                const dvec3 there = cases::moved(m, step / 2000.0, p);
                EXPECT_LE(cases::outside(all, there), 1e-14);
                sampled.include(vec3(there));
            }
        }
        EXPECT_LT(cases::diagonal(all), 1.05 * cases::diagonal(sampled));
    }
}

TEST(Motion, swept_bounds_hold_the_arc_of_a_half_turn) {
    Motion m;  // half a turn about z at the origin
    m.rotation = {Motion::Quaternion{0, 0, 0, 1}, Motion::Quaternion{0, 0, 1, 0}};
    const Box box = swept(m, {vec3(1, 0, 0), vec3(1, 0, 0)});
    EXPECT_GE(box.hi.y, 1);
    EXPECT_LT(box.hi.y, 1.01f);
    EXPECT_LE(box.lo.x, -1);
    EXPECT_GT(box.lo.y, -0.01f);
}

TEST(Motion, swept_bounds_of_a_shift_are_its_two_ends) {
    Motion m;
    m.translation = {vec3(0), vec3(2, 0, -1)};
    const Box box = swept(m, {vec3(0), vec3(1)});
    EXPECT_NEAR(box.lo.z, -1, 1e-6);
    EXPECT_NEAR(box.hi.x, 3, 1e-6);
    EXPECT_NEAR(box.lo.x, 0, 1e-6);
}

TEST(Motion, that_is_not_rigid_is_refused) {
    Motion m;
    EXPECT_NO_THROW(require_rigid(m));
    m.rotation[1] = {0, 0, 0, 1.01f};
    EXPECT_THROW(require_rigid(m), std::invalid_argument);
    m.rotation[1] = {0, 0, 0, -1};
    EXPECT_THROW(require_rigid(m), std::invalid_argument);
    m.rotation[1] = {0, 0, 0, std::nanf("")};
    EXPECT_THROW(require_rigid(m), std::invalid_argument);
    m = {};
    m.translation[1].x = infinity;
    EXPECT_THROW(require_rigid(m), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
