#include <gtest/gtest.h>

#include "accel/core/primitive/padding.h"
#include "tests/core/shapes.h"

namespace rayshoot {
namespace {

template <class Shape>
class Bounds : public testing::Test {};
TYPED_TEST_SUITE(Bounds, cases::Shapes);

TYPED_TEST(Bounds, contain_every_point_and_touch_the_surface) {
    cases::Random random(61);
    for (int i = 0; i < 500; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Box box = bounds(shape), stored = cases::alone(shape).bounds(0);
        EXPECT_TRUE(stored.contains(box));
        const double rounding = cases::spot_error(box) + 0x1p-24 * largest_coordinate(box);
        for (int j = 0; j < 50; ++j) {
            const dvec3 point = cases::spot_on(shape, random).point;
            EXPECT_LE(cases::outside(box, point), rounding);
            EXPECT_EQ(cases::outside(stored, point), 0);
        }
    }
}

TYPED_TEST(Bounds, are_padded_by_the_documented_share) {
    cases::Random random(62);
    for (int i = 0; i < 500; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Box box = bounds(shape), stored = cases::alone(shape).bounds(0);
        EXPECT_EQ(stored, padded(box, 0));
        const double padding = 0x1p-22 * largest_coordinate(box);
        for (int axis = 0; axis < 3; ++axis) {
            const double below = double(box.lo[axis]) - stored.lo[axis];
            const double above = double(stored.hi[axis]) - box.hi[axis];
            EXPECT_GE(below, padding);
            EXPECT_GE(above, padding);
            EXPECT_LE(std::max(below, above), 2 * padding);
        }
    }
}

TYPED_TEST(Bounds, support_is_reached_and_not_passed) {
    cases::Random random(63);
    for (int i = 0; i < 500; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Geometry geometry = cases::alone(shape);
        const vec3 direction = vec3(random.magnitude(-8, 8) * random.unit());
        const double limit = geometry.support(0, direction);
        const double size = length(dvec3(direction));
        double farthest = -1e300;
        for (int j = 0; j < 200; ++j)
            farthest =
                std::max(farthest, dot(cases::spot_on(shape, random).point, dvec3(direction)));
        EXPECT_LE(farthest, limit + cases::spot_error(bounds(shape)) * size);
        // Samples come near the extreme point; the box is at least as large as the shape.
        EXPECT_GE(farthest, limit - 0.25 * size * cases::diagonal(bounds(shape)));
    }
}

TEST(Bounds, of_frusta_touch_their_circles) {
    const Frustum cone{{1, 2, 3}, 2, {1, 2, 7}, 0.5f};
    const Box box = bounds(cone), circles{{-1, 0, 3}, {3, 4, 7}};
    EXPECT_TRUE(box.contains(circles));
    EXPECT_TRUE(circles.grown(0x1p-21f).contains(box));  // 2^-23 of half length and largest radius
}

TEST(Bounds, of_a_polygon_in_a_plane_across_an_axis_are_flat) {
    const std::array<vec3, 4> corners{vec3(0, 0, 0.1f), vec3(1, 0, 0.1f), vec3(1, 1, 0.1f),
                                      vec3(0, 1, 0.1f)};
    const Box box = bounds(make_polygon(corners, {}));
    EXPECT_EQ(box.lo, vec3(0, 0, 0.1f));
    EXPECT_EQ(box.hi, vec3(1, 1, 0.1f));
}

TEST(Bounds, of_a_watertight_scene_are_padded_by_its_size) {
    const Triangle triangle{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    const Geometry geometry = cases::alone(triangle, Precision::watertight);
    EXPECT_NEAR(geometry.padding(), 0x1p-19 * (5 + 4), 1e-9);
    EXPECT_EQ(geometry.bounds(0), padded(bounds(triangle), geometry.padding()));
    EXPECT_EQ(cases::alone(triangle).padding(), 0);
}

}  // namespace
}  // namespace rayshoot
