#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "accel/core/geometry.h"

namespace rayshoot {
namespace {

const vec3 not_a_number(0, std::nanf(""), 0), infinite(infinity, 0, 0);
const std::array<vec3, 4> square{vec3(0), vec3(1, 0, 0), vec3(1, 1, 0), vec3(0, 1, 0)};

TEST(Builder, refuses_numbers_that_are_not_finite) {
    GeometryBuilder b;
    for (const vec3& bad : {not_a_number, infinite}) {
        EXPECT_THROW(b.add_vertex(bad), std::invalid_argument);
        EXPECT_THROW(b.add_vertex(vec3(0), bad), std::invalid_argument);
        EXPECT_THROW(b.add_triangle(vec3(0), bad, vec3(1)), std::invalid_argument);
        EXPECT_THROW(b.add_sphere({bad, 1}), std::invalid_argument);
        EXPECT_THROW(b.add_frustum({bad, 1, vec3(0), 1}), std::invalid_argument);
        EXPECT_THROW(b.add_frustum({vec3(0), 1, bad, 1}), std::invalid_argument);
        auto corners = square;
        corners[2] = bad;
        EXPECT_THROW(b.add_polygon(corners), std::invalid_argument);
        EXPECT_THROW(b.add_polygon(square, corners), std::invalid_argument);
        Motion motion;
        motion.pivot = bad;
        EXPECT_THROW(b.add_motion(motion), std::invalid_argument);
    }
    EXPECT_EQ(b.size(), 0u);
}

TEST(Builder, refuses_negative_and_infinite_radii) {
    GeometryBuilder b;
    for (const float bad : {-1.0f, -0x1p-149f, infinity, std::nanf("")}) {
        EXPECT_THROW(b.add_sphere({vec3(0), bad}), std::invalid_argument);
        EXPECT_THROW(b.add_frustum({vec3(0), bad, vec3(1), 1}), std::invalid_argument);
        EXPECT_THROW(b.add_frustum({vec3(0), 1, vec3(1), bad}), std::invalid_argument);
    }
    EXPECT_EQ(b.size(), 0u);
}

TEST(Builder, refuses_vertices_and_motions_that_do_not_exist) {
    GeometryBuilder b;
    b.add_vertex(vec3(0));
    b.add_vertex(vec3(1));
    EXPECT_THROW(b.add_triangle({0, 1, 2}), std::invalid_argument);
    EXPECT_THROW(b.add_triangle({0, 1, 0xffffffff}), std::invalid_argument);
    EXPECT_THROW(b.add_triangle({0, 1, 1}, 1), std::invalid_argument);
    EXPECT_THROW(b.add_sphere({vec3(0), 1}, 7), std::invalid_argument);
    EXPECT_EQ(b.size(), 0u);
}

TEST(Builder, names_what_is_wrong) {
    GeometryBuilder b;
    try {
        b.add_triangle({5, 0, 0});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("vertex 5"), std::string::npos) << error.what();
    }
}

TEST(Builder, makes_a_triangle_of_three_corners) {
    GeometryBuilder b;
    const std::array<vec3, 3> up{vec3(0, 0, 1), vec3(0, 0, 1), vec3(0, 0, 1)};
    b.add_polygon(std::span(square).first(3), up);
    b.add_polygon(square);
    const Geometry g = std::move(b).build();
    EXPECT_EQ(g.ref(0).kind, PrimitiveKind::triangle);
    EXPECT_EQ(g.ref(1).kind, PrimitiveKind::polygon);
    EXPECT_EQ(g.triangle(0).c, square[2]);
}

TEST(Builder, an_empty_geometry_is_a_geometry) {
    for (const Precision precision : {Precision::standard, Precision::watertight}) {
        const Geometry g = GeometryBuilder().build(precision);
        EXPECT_EQ(g.size(), 0u);
        EXPECT_TRUE(g.bounds().empty());
        EXPECT_EQ(g.error_radius(10), 0);
        EXPECT_EQ(g.padding(), 0);
        EXPECT_TRUE(g.only_static_triangles());
    }
}

RC_GTEST_PROP(Builder, numbers_primitives_in_the_order_they_come, ()) {
    const auto kinds = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5));
    GeometryBuilder b;
    const std::uint32_t motion = b.add_motion({});
    std::array<std::uint32_t, primitive_kinds> counts{};
    bool only_static = true;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        std::uint32_t number = 0;
        switch (kinds[i]) {
            case 0:
                number = b.add_triangle(square[0], square[1], square[2]);
                break;
            case 1:
                number = b.add_sphere({vec3(float(i)), 1});
                break;
            case 2:
                number = b.add_frustum({vec3(0), 1, vec3(1), 0});
                break;
            case 3:
                number = b.add_polygon(square);
                break;
            default:
                number = b.add_sphere({vec3(float(i)), 2}, motion);
        }
        RC_ASSERT(number == i);
        ++counts[static_cast<std::size_t>(kinds[i] == 4 ? 1 : kinds[i])];
        only_static = only_static && kinds[i] == 0;
    }
    const Geometry g = std::move(b).build();
    RC_ASSERT(g.size() == kinds.size());
    RC_ASSERT(g.count_by_kind() == counts);
    RC_ASSERT(g.only_static_triangles() == only_static);
    for (std::uint32_t i = 0; i < g.size(); ++i) {
        RC_ASSERT(g.bounds().contains(g.bounds(i)));
        if (kinds[i] == 1 || kinds[i] == 4) {
            RC_ASSERT(g.sphere(g.ref(i).index).centre.x == float(i));
            RC_ASSERT(g.ref(i).motion == (kinds[i] == 4 ? motion : no_motion));
        }
    }
}

}  // namespace
}  // namespace rayshoot
