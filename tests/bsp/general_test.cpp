#include <gtest/gtest.h>

#include "accel/bsp/general/sub_tree.h"
#include "accel/core/catalogue.h"
#include "tests/bsp/scenes.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <random>

namespace rayshoot::bsp_test {
namespace {

class Random {
public:
    explicit Random(unsigned seed) : random_(seed) {}
    float between(float lo, float hi) {
        return std::uniform_real_distribution<float>(lo, hi)(random_);
    }
    vec3 in_cube(float half) {
        const float x = between(-half, half), y = between(-half, half), z = between(-half, half);
        return {x, y, z};
    }

private:
    std::mt19937 random_;
};

/// Planks along (1, 1, 0), side by side in the plane x = y: a wall whose box is a whole cube.
Geometry diagonal_wall() {
    constexpr int planks = 200;
    GeometryBuilder builder;
    for (int i = 0; i < planks; ++i) {
        const float z = static_cast<float>(i) / planks, top = static_cast<float>(i + 1) / planks;
        builder.add_triangle(vec3(0, 0, z), vec3(1, 1, z), vec3(1, 1, top));
        builder.add_triangle(vec3(0, 0, z), vec3(1, 1, top), vec3(0, 0, top));
    }
    return std::move(builder).build(Precision::watertight);
}

std::vector<Ray> rays_between_points_of(const Box& box, std::size_t count) {
    Random random(2);
    const auto point = [&] { return box.centre() + random.in_cube(0.5f) * box.size(); };
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 origin = point();
        rays.push_back({origin, 0, point() - origin});
    }
    return rays;
}

struct Traced {
    std::vector<Hit> hits;
    Counters counters;
    Footprint footprint;
};
Traced traced(const Geometry& geometry, std::string_view spec, std::span<const Ray> rays) {
    const auto accel = build(built_in_catalogue(), spec, {geometry});
    const auto session = accel->open(Mode::counting);
    Traced all{std::vector<Hit>(rays.size()), {}, accel->footprint()};
    session->closest({.rays = rays}, all.hits);
    all.counters = *session->counters(RayKind::secondary);
    return all;
}

TEST(GeneralBsp, tests_far_fewer_objects_of_a_diagonal_wall_than_a_kd_tree) {
    const Geometry wall = diagonal_wall();
    const std::vector<Ray> rays = rays_between_points_of(wall.bounds(), 4000);
    const Traced general = traced(wall, "bsp_general", rays),
                 kd = traced(wall, "bsp_general:general=0", rays);
    EXPECT_EQ(general.hits, kd.hits);
    EXPECT_LT(3 * general.counters[Event::object_test], kd.counters[Event::object_test]);
}

TEST(GeneralBsp, is_a_kd_tree_where_primitives_lie_across_the_axes) {
    GeometryBuilder builder;
    for (int i = 0; i < 500; ++i) {
        const vec3 at(static_cast<float>(i % 9), static_cast<float>(i / 9 % 9),
                      static_cast<float>(i / 81));
        builder.add_polygon(
            std::array{at, at + vec3(0, 0.7f, 0), at + vec3(0, 0.7f, 0.7f), at + vec3(0, 0, 0.7f)});
    }
    const Geometry squares = std::move(builder).build();
    const Membership membership({squares}, Overlap::exact);
    const BspSketch tree = build_general(squares, membership,
                                         {.sah = {}, .deepest = 40, .most_references = 10000}, 32);
    EXPECT_GT(tree.nodes.size(), 1u);
    EXPECT_TRUE(tree.planes.empty());
}

/// visit(leaf's members) for every leaf in whose cell x is: inside planes across the axes, and not
/// beyond oblique ones by more than `margin`.
template <class Visit>
void each_leaf_at(const BspSketch& sketch, const ObliqueFrame& frame, const dvec3& x, double margin,
                  const Visit& visit, std::uint32_t number = 0) {
    const BspSketch::Node& node = sketch.nodes[number];
    if (node.kind == BspSketch::Kind::part)
        return each_leaf_at(*sketch.parts[node.first], frame, x, margin, visit);
    if (node.kind == BspSketch::Kind::leaf) return visit(sketch.members_of(node));
    const bool oblique = node.axis == oblique_axis;
    const double height = oblique ? sketch.planes[std::bit_cast<std::uint32_t>(node.plane)].height(
                                        x - dvec3(frame.centre))
                                  : x[node.axis] - double(node.plane);
    if (oblique ? height <= margin : height < 0)
        each_leaf_at(sketch, frame, x, margin, visit, node.first);
    if (oblique ? height >= -margin : height > 0)
        each_leaf_at(sketch, frame, x, margin, visit, node.first + 1);
}

/// Any point of the primitive's surface.
dvec3 point_of(const Geometry& geometry, std::uint32_t primitive, Random& random) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    if (ref.kind == PrimitiveKind::triangle) {
        const Triangle t = geometry.triangle(ref.index);
        double u = random.between(0, 1), v = random.between(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        return dvec3(t.a) + u * (dvec3(t.b) - dvec3(t.a)) + v * (dvec3(t.c) - dvec3(t.a));
    }
    const Sphere& sphere = geometry.sphere(ref.index);
    return dvec3(sphere.centre) +
           double(sphere.radius) * normalised(dvec3(random.in_cube(1)) + dvec3(1e-9, 0, 0));
}

TEST(GeneralBsp, lists_a_primitive_on_both_sides_of_oblique_planes_near_a_point_of_it) {
    for (const NamedGeometry& scene : hard_scenes())
        for (const std::size_t few : {std::size_t{32}, std::size_t{500}}) {
            SCOPED_TRACE(scene.name);
            const Geometry& geometry = scene.geometry;
            const Membership membership({geometry}, Overlap::exact);
            const BspSketch tree = build_general(
                geometry, membership,
                {.sah = {}, .deepest = 40, .most_references = most_references(geometry.size())},
                few);
            const ObliqueFrame frame(geometry, membership);
            Random random(3);
            std::size_t missing = 0;
            for (std::uint32_t i = 0; i < geometry.size(); ++i)
                for (int j = 0; j < 50; ++j)
                    each_leaf_at(
                        tree, frame, point_of(geometry, i, random), double(membership.radius()),
                        [&](std::span<const std::uint32_t> members) {
                            missing += !std::binary_search(members.begin(), members.end(), i);
                        });
            EXPECT_EQ(missing, 0u);
        }
}

TEST(ObliqueFrame, knows_which_side_of_a_plane_a_ray_is_on_up_to_eight_units_of_its_distance) {
    GeometryBuilder builder;
    builder.add_triangle(vec3(999), vec3(1001, 999, 1000), vec3(1000, 1001, 1001));
    const Geometry geometry = std::move(builder).build(Precision::watertight);
    const Membership membership({geometry}, Overlap::exact);
    const ObliqueFrame frame(geometry, membership);
    const double farthest = 2 * double(membership.reach());  // somewhat more than it is
    double worst = 0;
    Random random(4);
    for (int i = 0; i < 200000; ++i) {
        const vec3 normal(normalised(dvec3(random.in_cube(1))));
        const ObliquePlane plane{normal, random.between(-1, 1)};
        const vec3 origin = frame.centre + random.in_cube(1.7f);
        vec3 direction = random.in_cube(1);
        if (i % 2 == 0) {  // nearly along the plane
            const vec3 along_it = cross(normal, direction);
            direction = along_it + random.in_cube(1e-6f);
        }
        direction *= std::exp2(random.between(-50, 50));
        const ObliqueRay ray(frame, origin, direction);
        const float slope = ray.slope(plane), at = ray.at(plane, slope);
        const auto check = [&](float t, double side) {
            const dvec3 x = frame.local(origin) + double(t) * dvec3(direction);
            if (length(x) > double(membership.reach())) return;
            worst = std::max(worst, side * plane.height(x));
        };
        const double near_side = std::signbit(slope) ? -1 : 1;  // below the plane: heights < 0
        const float size = static_cast<float>(length(dvec3(direction)));
        for (const float t : {0.0f, at, random.between(0, 4) / size, at * (1 - 0x1p-20f)}) {
            if (!(t > at)) check(t, near_side);
            if (!(t < at)) check(t, -near_side);
        }
    }
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, 8 * 0x1p-24 * farthest);
}

TEST(GeneralBsp, answers_rays_from_far_away_and_of_any_length_without_testing_everything) {
    const Geometry geometry = random_triangles(20000, 0.02f, 12);
    const std::vector<Ray> inside = rays_between_points_of(geometry.bounds(), 300);
    for (const float scale : {1e-30f, 1.0f, 1e30f})
        for (const float from : {1.0f, 1e5f}) {
            std::vector<Ray> rays = inside;
            for (Ray& ray : rays) {
                const vec3 origin = ray.origin + ray.direction * -from;
                ray = {origin, 0, ray.direction * scale};
            }
            const Traced ours = traced(geometry, "bsp_general", rays);
            EXPECT_EQ(ours.hits, traced(geometry, "brute_force", rays).hits) << scale;
            EXPECT_LT(ours.counters[Event::object_test], rays.size() * geometry.size() / 4);
        }
}

TEST(GeneralBsp, keeps_to_the_bound_on_references) {
    for (const NamedGeometry& scene : hard_scenes())
        for (const std::string_view spec : {"bsp_general", "bsp_general:general=4096"}) {
            SCOPED_TRACE(scene.name);
            const auto accel = build(built_in_catalogue(), spec, {scene.geometry});
            EXPECT_LE(accel->footprint().references, 10 * scene.geometry.size() + 64);
        }
}

TEST(GeneralBsp, is_built_the_same_by_any_number_of_threads) {
    const Geometry geometry = random_triangles(20000, 0.03f, 7);
    const std::vector<Ray> rays = rays_between_points_of(geometry.bounds(), 1000);
    std::optional<Traced> first;
    for (const std::size_t threads : {1u, 2u, 5u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const Traced now = traced(geometry, "bsp_general", rays);
        if (!first) first = now;
        EXPECT_EQ(now.counters, first->counters);
        EXPECT_EQ(now.footprint.references, first->footprint.references);
        EXPECT_EQ(now.footprint.bytes, first->footprint.bytes);
    }
}

}  // namespace
}  // namespace rayshoot::bsp_test
