#include <gtest/gtest.h>

#include "tests/core/shapes.h"

namespace rayshoot {
namespace {

template <class Shape>
class Normal : public testing::Test {};
TYPED_TEST_SUITE(Normal, cases::Shapes);

Ray ray_to(const dvec3& point, const dvec3& from) {
    Ray ray;
    ray.origin = vec3(from);
    ray.direction = vec3(point - dvec3(ray.origin));
    return ray;
}

TYPED_TEST(Normal, is_unit_and_that_of_the_surface) {
    cases::Random random(91);
    for (int i = 0; i < 2000; ++i) {
        const auto shape = cases::make<TypeParam>(random);
        const Geometry geometry = cases::alone(shape);
        const double size = cases::diagonal(geometry.bounds());
        const cases::Spot spot = cases::spot_on(shape, random);
        const Ray ray = ray_to(spot.point, spot.point + size * random.unit());
        const Normals normals = geometry.normal(ray, {1, 0, 0.25f, 0.25f});
        EXPECT_NEAR(length(normals.geometric), 1, 1e-6);
        EXPECT_EQ(normals.shading, normals.geometric);
        if constexpr (std::is_same_v<TypeParam, Frustum>) {
            const double far = length(spot.point) + size;  // float points, thin frusta
            const double radius = std::max(shape.base_radius, shape.apex_radius);
            if (far > 1000 * radius || shape.base_radius == 0 || shape.apex_radius == 0) continue;
            EXPECT_GT(dot(dvec3(normals.geometric), spot.normal), 0.999);
        } else if constexpr (std::is_same_v<TypeParam, Sphere>) {
            if (length(spot.point) > 1000 * double(shape.radius)) continue;
            EXPECT_GT(dot(dvec3(normals.geometric), spot.normal), 0.999);
        } else {
            EXPECT_GT(dot(dvec3(normals.geometric), spot.normal), 0.9999);
        }
    }
}

TEST(Normal, of_a_triangle_follows_its_winding) {
    const Geometry geometry = cases::alone(Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    const Ray ray = ray_to({0.2, 0.2, 0}, {0.2, 0.2, -1});
    EXPECT_EQ(geometry.normal(ray, {1, 0, 0.2f, 0.2f}).geometric, vec3(0, 0, 1));
}

TEST(Normal, of_a_triangle_is_interpolated_between_its_vertices) {
    GeometryBuilder builder;
    builder.add_vertex({0, 0, 0}, {0, 0, 1});
    builder.add_vertex({1, 0, 0}, {1, 0, 0});
    builder.add_vertex({0, 1, 0}, {0, 1, 0});
    builder.add_vertex({1, 1, 0});
    builder.add_triangle({0, 1, 2});
    builder.add_triangle({1, 3, 2});
    const Geometry geometry = std::move(builder).build();
    const Ray ray = ray_to({0.5, 0, 0}, {0.5, 0, 1});
    const Normals normals = geometry.normal(ray, {1, 0, 0.5f, 0});
    EXPECT_EQ(normals.geometric, vec3(0, 0, 1));
    EXPECT_NEAR(normals.shading.x, std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(normals.shading.z, std::sqrt(0.5), 1e-6);
    EXPECT_EQ(geometry.normal(ray, {1, 1, 0.5f, 0}).shading, vec3(0, 0, 1));  // one has none
}

TEST(Normal, of_a_polygon_is_interpolated_between_its_corners) {
    const std::array<vec3, 4> corners{vec3(0, 0, 0), vec3(2, 0, 0), vec3(2, 2, 0), vec3(0, 2, 0)};
    const std::array<vec3, 4> normals{vec3(-1, 0, 1), vec3(1, 0, 1), vec3(1, 0, 1), vec3(-1, 0, 1)};
    GeometryBuilder builder;
    builder.add_polygon(corners, normals);
    const Geometry geometry = std::move(builder).build();
    const auto shading = [&](double x, double y) {
        return geometry.normal(ray_to({x, y, 0}, {x, y, 3}), {1, 0, 0, 0}).shading;
    };
    EXPECT_NEAR(shading(1, 1).x, 0, 1e-6);
    EXPECT_NEAR(shading(1, 1).z, 1, 1e-6);
    EXPECT_NEAR(shading(0, 0).x, -std::sqrt(0.5), 1e-6);   // at a corner
    EXPECT_NEAR(shading(2, 0.5).x, std::sqrt(0.5), 1e-6);  // on an edge
    EXPECT_NEAR(shading(1, 0).x, 0, 1e-6);
    EXPECT_GT(shading(1.5, 0.7).x, 0.1f);
    EXPECT_NEAR(shading(1.5, 1e-6).x, shading(1.5, 0).x, 1e-3);
}

TEST(Normal, of_the_tip_of_a_cone_points_along_its_axis) {
    const Geometry geometry = cases::alone(Frustum{{0, 0, 0}, 1, {0, 0, 2}, 0});
    const Ray ray = ray_to({0, 0, 2}, {0, 0, 4});
    EXPECT_EQ(geometry.normal(ray, {1, 0, 0, 0}).geometric, vec3(0, 0, 1));
}

TEST(Normal, turns_with_a_moving_primitive) {
    Motion motion;  // a quarter turn about z
    const auto half = static_cast<float>(std::sqrt(0.5));
    motion.rotation[1] = {0, 0, half, half};
    GeometryBuilder builder;
    builder.add_triangle({1, -1, -1}, {1, 1, -1}, {1, 0, 1}, builder.add_motion(motion));
    const Geometry geometry = std::move(builder).build();
    Ray ray = ray_to({0, 1, 0}, {0, 5, 0});
    ray.time = 1;
    const vec3 normal = geometry.normal(ray, {1, 0, 0.25f, 0.5f}).geometric;
    EXPECT_NEAR(normal.y, 1, 1e-6);
    ray.time = 0;
    EXPECT_NEAR(geometry.normal(ray, {1, 0, 0.25f, 0.5f}).geometric.x, 1, 1e-6);
}

}  // namespace
}  // namespace rayshoot
