#include <gtest/gtest.h>

#include "accel/bsp/kd_builder.h"
#include "accel/bsp/midpoint.h"
#include "accel/core/catalogue.h"
#include "tests/bsp/scenes.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <random>

namespace rayshoot::bsp_test {
namespace {

constexpr std::uint64_t multiple = 10;

struct NamedBuild {
    std::string name;
    BspSketch (*build)(const Geometry&, const Membership&);
};

KdSettings settings_for(const Geometry& geometry) {
    return {.sah = {}, .deepest = 40, .most_references = multiple * geometry.size() + 64};
}
BspSketch by_bins(const Geometry& geometry, const Membership& membership) {
    return build_by_bins(geometry, membership, settings_for(geometry));
}
BspSketch by_events(const Geometry& geometry, const Membership& membership) {
    return build_by_events(geometry, membership, settings_for(geometry));
}
BspSketch midpoint(const Geometry& geometry, const Membership& membership) {
    return build_midpoint(geometry, membership,
                          {.most_references = multiple * geometry.size() + 64});
}
const std::vector<NamedBuild> all_builds{
    {"bins", by_bins}, {"events", by_events}, {"midpoint", midpoint}};

/// Calls check(geometry, membership, tree) for every scene, overlap and build.
template <class Check>
void for_all(const Check& check) {
    for (const NamedGeometry& scene : hard_scenes())
        for (const Overlap overlap : {Overlap::bounds, Overlap::exact})
            for (const NamedBuild& build : all_builds) {
                SCOPED_TRACE(scene.name + ", " + build.name +
                             (overlap == Overlap::exact ? ", exact" : ", bounds"));
                const Membership membership({scene.geometry}, overlap);
                check(scene.geometry, membership, build.build(scene.geometry, membership));
            }
}

bool strictly_inside(const vec3& p, const Box& cell) {
    return cell.lo.x < p.x && p.x < cell.hi.x && cell.lo.y < p.y && p.y < cell.hi.y &&
           cell.lo.z < p.z && p.z < cell.hi.z;
}

/// Any point of the primitive's surface.
vec3 point_of(const Geometry& geometry, std::uint32_t primitive, float u, float v) {
    const PrimitiveRef& ref = geometry.ref(primitive);
    if (ref.kind == PrimitiveKind::triangle) {
        const Triangle t = geometry.triangle(ref.index);
        if (u + v > 1) return point_of(geometry, primitive, 1 - u, 1 - v);
        return t.a + u * (t.b - t.a) + v * (t.c - t.a);
    }
    const Sphere& sphere = geometry.sphere(ref.index);
    const float z = 2 * u - 1, r = std::sqrt(std::max(0.0f, 1 - z * z));
    return sphere.centre +
           sphere.radius * vec3(r * std::cos(6.2831853f * v), r * std::sin(6.2831853f * v), z);
}

TEST(BspBuilders, list_a_primitive_in_every_cell_that_holds_a_point_of_it) {
    for_all([](const Geometry& geometry, const Membership& membership, const BspSketch& tree) {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> weight(0, 1);
        std::vector<std::vector<vec3>> points(geometry.size());
        for (std::uint32_t i = 0; i < geometry.size(); ++i)
            for (int j = 0; j < 20; ++j)
                points[i].push_back(point_of(geometry, i, weight(random), weight(random)));
        std::vector<std::size_t> found(geometry.size());
        std::size_t missing = 0;
        each_leaf(tree, membership.space(),
                  [&](std::span<const std::uint32_t> members, const Box& cell) {
                      ASSERT_TRUE(std::is_sorted(members.begin(), members.end()));
                      for (std::uint32_t i = 0; i < geometry.size(); ++i) {
                          if (!geometry.bounds(i).overlaps(cell)) continue;
                          const bool listed = std::binary_search(members.begin(), members.end(), i);
                          for (const vec3& p : points[i]) {
                              found[i] += listed && cell.contains(p);
                              missing += !listed && strictly_inside(p, cell);
                          }
                      }
                  });
        EXPECT_EQ(missing, 0u);
        for (const std::size_t times : found) EXPECT_GE(times, 20u);
    });
}

TEST(BspBuilders, keep_to_the_bound_on_references_and_say_where_they_stop) {
    for_all([](const Geometry& geometry, const Membership& membership, const BspSketch& tree) {
        std::size_t references = 0;
        each_leaf(tree, membership.space(),
                  [&](std::span<const std::uint32_t> members, const Box&) {
                      references += members.size();
                  });
        EXPECT_LE(references, multiple * geometry.size() + 64);
    });
    const Geometry needles = std::move(hard_scenes()[5].geometry);
    const auto accel = build(built_in_catalogue(), "bsp:overlap=bounds,build=midpoint", {needles});
    EXPECT_LE(accel->footprint().references, multiple * needles.size() + 64);
    EXPECT_NE(accel->footprint().remark, "");
}

TEST(BspBuilders, leave_coincident_primitives_together) {
    const Geometry geometry = std::move(hard_scenes()[4].geometry);
    const auto accel = build(built_in_catalogue(), "bsp", {geometry});
    EXPECT_LE(accel->footprint().references, 2 * geometry.size());
}

struct Flat {
    std::vector<std::uint32_t> members;
    std::vector<Box> cells;
    bool operator==(const Flat&) const = default;
};
Flat flattened(const BspSketch& tree, const Box& space) {
    Flat flat;
    each_leaf(tree, space, [&](std::span<const std::uint32_t> members, const Box& cell) {
        flat.members.insert(flat.members.end(), members.begin(), members.end());
        flat.members.push_back(no_primitive);
        flat.cells.push_back(cell);
    });
    return flat;
}

TEST(BspBuilders, build_the_same_tree_with_any_number_of_threads) {
    const Geometry geometry = random_triangles(30000, 0.02f, 7);
    const Membership membership({geometry}, Overlap::exact);
    for (const NamedBuild& build : all_builds) {
        SCOPED_TRACE(build.name);
        Flat first;
        for (const std::size_t threads : {1u, 2u, 5u, 5u}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            const Flat tree = flattened(build.build(geometry, membership), membership.space());
            if (first.cells.empty()) first = tree;
            EXPECT_EQ(tree, first) << threads;
        }
    }
}

/// MacDonald & Booth 1990, word by word: the least cost of all planes at faces of boxes.
float least_cost(const Sah& sah, const Box& cell, std::span<const Reference> references) {
    float least = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        for (const Reference& at : references)
            for (const float plane : {at.lo[i], -at.minus_hi[i]})
                for (const bool planar_left : {true, false}) {
                    if (!(cell.lo[axis] < plane && plane < cell.hi[axis])) continue;
                    const KdSplit split{0, axis, plane, planar_left};
                    Box left_box = cell, right_box = cell;
                    left_box.hi[axis] = right_box.lo[axis] = plane;
                    std::uint32_t left = 0, right = 0;
                    for (const Reference& reference : references) {
                        left += split.in_left(reference);
                        right += split.in_right(reference);
                    }
                    least = std::min(least,
                                     split_cost(sah, left_box.half_area() / cell.half_area(), left,
                                                right_box.half_area() / cell.half_area(), right));
                }
    }
    return least;
}

TEST(KdSplits, counted_ones_cost_what_the_best_of_all_planes_costs) {
    for (const NamedGeometry& scene : hard_scenes()) {
        SCOPED_TRACE(scene.name);
        const Membership membership({scene.geometry}, Overlap::bounds);
        References all = all_references(scene.geometry, membership);
        for (const std::size_t size :
             {std::size_t{1}, std::size_t{7}, std::size_t{64}, most_counted}) {
            if (size > all.size()) continue;
            const auto some = std::span(all).first(size);
            const Box cell = membership.space();
            const KdSplit split = counted_split({}, cell, some);
            const float least = least_cost({}, cell, some);
            if (least == infinity) EXPECT_EQ(split.cost, infinity);
            else EXPECT_NEAR(split.cost, least, 1e-4f * least);
        }
    }
}

TEST(KdSplits, swept_ones_cost_what_the_best_of_all_planes_costs) {
    for (const float size : {0.02f, 0.2f}) {
        const Geometry geometry = random_triangles(300, size, 8);
        const Membership membership({geometry}, Overlap::bounds);
        KdSettings settings = settings_for(geometry);
        settings.deepest = 1;
        const BspSketch tree = build_by_events(geometry, membership, settings);
        ASSERT_EQ(tree.nodes[0].kind, BspSketch::Kind::interior);
        const References all = all_references(geometry, membership);
        const Box& cell = membership.space();
        const KdSplit split{0, tree.nodes[0].axis, tree.nodes[0].plane, true};
        Box left_box = cell, right_box = cell;
        left_box.hi[split.axis] = right_box.lo[split.axis] = split.plane;
        std::uint32_t left = 0, right = 0;
        for (const Reference& reference : all) {
            left += split.in_left(reference);
            right += split.in_right(reference);
        }
        const float cost = split_cost({}, left_box.half_area() / cell.half_area(), left,
                                      right_box.half_area() / cell.half_area(), right);
        const float least = least_cost({}, cell, all);
        EXPECT_NEAR(cost, least, 1e-4f * least);
    }
}

TEST(KdSplits, over_bins_cost_little_more_than_the_best) {
    const Geometry geometry = random_triangles(5000, 0.03f, 9);
    const Membership membership({geometry}, Overlap::bounds);
    const References all = all_references(geometry, membership);
    const auto some = std::span(all).first(1000);
    const float least = least_cost({}, membership.space(), some);
    const float cost = binned_split({}, membership.space(), some).cost;
    EXPECT_LE(cost, 1.1f * least);
}

TEST(KdSplits, cut_off_nothing_but_empty_space_where_one_test_is_enough) {
    const Geometry geometry = random_triangles(4, 0.1f, 10);
    const Membership membership({geometry}, Overlap::bounds);
    const References all = all_references(geometry, membership);
    const Box cell{vec3(-1), vec3(2)};
    const KdSplit split = cutting_split({}, cell, all);
    // No plane with primitives on both sides costs less than a leaf.
    EXPECT_LT(split.cost, leaf_cost({}, 4));
    EXPECT_NEAR(split.cost, least_cost({}, cell, all), 1e-4f);
}

TEST(KdSplits, put_what_lies_in_the_plane_on_one_side_only) {
    for (const bool planar_left : {true, false}) {
        const KdSplit split{0, 0, 1, planar_left};
        const Reference in_plane({vec3(1, 0, 0), vec3(1, 1, 1)}, 0);
        EXPECT_EQ(split.in_left(in_plane), planar_left);
        EXPECT_EQ(split.in_right(in_plane), !planar_left);
        const Reference below({vec3(0), vec3(1)}, 0), above({vec3(1), vec3(2)}, 0);
        EXPECT_TRUE(split.in_left(below) && !split.in_right(below));
        EXPECT_TRUE(split.in_right(above) && !split.in_left(above));
    }
}

}  // namespace
}  // namespace rayshoot::bsp_test
