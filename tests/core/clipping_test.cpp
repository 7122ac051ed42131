#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "accel/core/primitive/padding.h"
#include "tests/core/shapes.h"

namespace rayshoot {
namespace {

template <class Shape>
class Clipping : public testing::Test {};
TYPED_TEST_SUITE(Clipping, cases::Shapes);

TYPED_TEST(Clipping, loses_no_point) {
    cases::Random random(71);
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Geometry geometry = cases::alone(shape);
        const double size = cases::diagonal(bounds(shape));
        const Box box = cases::box_near(cases::spot_on(shape, random).point, size, random);
        const Box clipped = geometry.clipped_bounds(0, box, 0);
        EXPECT_TRUE(clipped.empty() || geometry.bounds(0).contains(clipped));
        const double rounding = cases::spot_error(bounds(shape));
        for (int j = 0; j < 50; ++j) {
            const dvec3 point = cases::spot_on(shape, random).point;
            if (cases::outside(box.grown(0), point) > 0) continue;
            // Well inside, so that the point's own rounding does not matter.
            if (cases::outside(box, point + dvec3(rounding)) > 0 ||
                cases::outside(box, point - dvec3(rounding)) > 0)
                continue;
            ++inside;
            EXPECT_TRUE(geometry.overlaps(0, box, 0));
            EXPECT_LE(cases::outside(clipped, point), rounding);
        }
    }
    EXPECT_GT(inside, 1000);
}

TYPED_TEST(Clipping, grows_by_the_radius_and_never_beyond_the_bounds) {
    cases::Random random(72);
    for (int i = 0; i < 2000; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Geometry geometry = cases::alone(shape);
        const double size = cases::diagonal(bounds(shape));
        const dvec3 point = cases::spot_on(shape, random).point;
        const Box box = cases::box_near(point, size, random);
        const auto radius = static_cast<float>(size * random.magnitude(-10, 0));
        const Box tight = geometry.clipped_bounds(0, box, 0);
        const Box loose = geometry.clipped_bounds(0, box, radius);
        EXPECT_EQ(tight.empty(), loose.empty());
        if (tight.empty()) continue;
        EXPECT_TRUE(loose.contains(tight));
        EXPECT_TRUE(geometry.bounds(0).contains(loose));
        if (radius < 0x1p-14f * largest_coordinate(tight))
            continue;  // the tight one is rounded too
        EXPECT_TRUE(loose.contains(tight.grown(0.99f * radius).intersection(geometry.bounds(0))));
    }
}

TYPED_TEST(Clipping, overlap_reaches_as_far_as_the_radius) {
    cases::Random random(73);
    int apart = 0;
    for (int i = 0; i < 3000; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Geometry geometry = cases::alone(shape);
        const double size = cases::diagonal(bounds(shape));
        const dvec3 point = cases::spot_on(shape, random).point;
        const double radius = size * random.magnitude(-8, 0);
        Box box;  // a point at most that far away
        box.include(vec3(point + 0.99 * radius * random.unit()));
        const double rounding = 0x1p-22 * (length(point) + size);
        const auto reach = static_cast<float>(radius + rounding);
        EXPECT_TRUE(geometry.overlaps(0, box, reach));
        // And a box beyond all of it does not.
        const Box beyond{geometry.bounds(0).hi + vec3(2 * reach),
                         geometry.bounds(0).hi + vec3(3 * reach)};
        apart += !geometry.overlaps(0, beyond, reach);
    }
    EXPECT_EQ(apart, 3000);
}

TEST(Clipping, overlap_is_told_from_a_near_miss) {
    const Triangle triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Geometry flat = cases::alone(triangle);
    EXPECT_FALSE(flat.overlaps(0, {vec3(0.6f, 0.6f, -1), vec3(1, 1, 1)}, 0));
    EXPECT_TRUE(flat.overlaps(0, {vec3(0.5f, 0.5f, -1), vec3(1, 1, 1)}, 0));
    EXPECT_FALSE(flat.overlaps(0, {vec3(0, 0, 0.1f), vec3(1, 1, 1)}, 0));

    const Geometry ball = cases::alone(Sphere{vec3(0), 1});
    EXPECT_FALSE(ball.overlaps(0, {vec3(-0.5f), vec3(0.5f)}, 0));  // all inside: no surface there
    EXPECT_FALSE(ball.overlaps(0, {vec3(0.6f), vec3(1)}, 0));
    EXPECT_TRUE(ball.overlaps(0, {vec3(0.57f), vec3(1)}, 0));

    const Geometry tube = cases::alone(Frustum{{0, 0, 0}, 1, {0, 0, 4}, 1});
    EXPECT_FALSE(tube.overlaps(0, {vec3(-0.5f, -0.5f, 1), vec3(0.5f, 0.5f, 2)}, 0));
    EXPECT_FALSE(tube.overlaps(0, {vec3(0.75f, 0.75f, 1), vec3(1, 1, 2)}, 0));
    EXPECT_TRUE(tube.overlaps(0, {vec3(0.7f, 0.7f, 1), vec3(1, 1, 2)}, 0));
}

TEST(Clipping, is_tight) {
    const Geometry slanted = cases::alone(Frustum{{0, 0, 0}, 0.1f, {8, 8, 0}, 0.1f});
    const Box part = slanted.clipped_bounds(0, {vec3(2, 0, -1), vec3(3, 8, 1)}, 0);
    EXPECT_GT(part.lo.y, 1.5f);
    EXPECT_LT(part.hi.y, 3.5f);

    const Geometry ball = cases::alone(Sphere{vec3(0), 1});
    const Box cap = ball.clipped_bounds(0, {vec3(0.8f, -1, -1), vec3(1, 1, 1)}, 0);
    EXPECT_NEAR(cap.hi.y, 0.6f, 1e-5);
    EXPECT_NEAR(cap.lo.z, -0.6f, 1e-5);
    const Box side = ball.clipped_bounds(0, {vec3(0, -0.6f, 0), vec3(1, 0.6f, 0)}, 0);
    EXPECT_NEAR(side.lo.x, 0.8f, 1e-5);
}

using Rational = boost::multiprecision::cpp_rational;
using Exact = std::array<Rational, 3>;

/// Sutherland-Hodgman again, but exact and on its own.
std::vector<Exact> clip_exactly(const Triangle& triangle, const Box& box) {
    std::vector<Exact> shape;
    for (const vec3& p : {triangle.a, triangle.b, triangle.c}) shape.push_back({p.x, p.y, p.z});
    for (std::size_t plane = 0; plane < 6; ++plane) {
        const std::size_t axis = plane / 2;
        const bool low = plane % 2 == 0;
        const int coordinate = static_cast<int>(axis);
        const Rational at = low ? box.lo[coordinate] : box.hi[coordinate];
        std::vector<Exact> kept;
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const Exact &here = shape[i], &next = shape[(i + 1) % shape.size()];
            const Rational from = low ? here[axis] - at : at - here[axis];
            const Rational to = low ? next[axis] - at : at - next[axis];
            if (from >= 0) kept.push_back(here);
            if ((from < 0) == (to < 0)) continue;
            const Rational share = from / (from - to);
            kept.push_back({here[0] + share * (next[0] - here[0]),
                            here[1] + share * (next[1] - here[1]),
                            here[2] + share * (next[2] - here[2])});
        }
        shape = kept;
    }
    return shape;
}

TEST(Clipping, of_triangles_agrees_with_rational_arithmetic) {
    cases::Random random(74);
    int parts = 0, nothing = 0;
    for (int i = 0; i < 2000; ++i) {
        const Triangle triangle = cases::triangle(random);
        Box box = cases::box_near(cases::spot_on(triangle, random).point, 1, random);
        if (random.below(2)) {
            const vec3 off = random.in_cube(0.3);
            box = {box.lo + off, box.hi + off};
        }
        const Box clipped = clipped_bounds(triangle, box);
        const auto exact = clip_exactly(triangle, box);
        const double margin = 0x1p-22 * largest_coordinate(bounds(triangle));
        if (exact.empty()) {
            ++nothing;
            EXPECT_TRUE(clipped.empty() || cases::diagonal(clipped) < 1);
            continue;
        }
        ++parts;
        EXPECT_TRUE(overlaps(triangle, box, 0));
        for (int axis = 0; axis < 3; ++axis) {
            Rational lo = exact[0][static_cast<std::size_t>(axis)], hi = lo;
            for (const Exact& p : exact) {
                lo = std::min(lo, p[static_cast<std::size_t>(axis)]);
                hi = std::max(hi, p[static_cast<std::size_t>(axis)]);
            }
            EXPECT_LE(Rational(clipped.lo[axis]), lo);
            EXPECT_GE(Rational(clipped.hi[axis]), hi);
            EXPECT_LE(lo.convert_to<double>() - clipped.lo[axis], margin);
            EXPECT_LE(clipped.hi[axis] - hi.convert_to<double>(), margin);
        }
    }
    EXPECT_GT(parts, 500);
    EXPECT_GT(nothing, 100);
}

}  // namespace
}  // namespace rayshoot
