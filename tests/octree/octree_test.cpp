#include "accel/core/catalogue.h"
#include "accel/core/structure.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <random>

/// What an octree answers and holds, in each of its forms: the rules that every subdivision of
/// space has to keep.
namespace rayshoot {
namespace {

std::unique_ptr<Accel> built(const std::string& spec, const Geometry& geometry) {
    return build(built_in_catalogue(), spec, {geometry, {}, {}, nullptr});
}

Hit nearest(const Accel& accel, const Ray& ray) {
    const auto session = accel.open(Mode::timing);
    Hit hit;
    session->closest({.rays = {&ray, 1}}, {&hit, 1});
    return hit;
}

/// The corners of a scene of side 16, as specks, so that cells and their planes are known.
GeometryBuilder framed() {
    GeometryBuilder builder;
    for (const float at : {0.0f, 16.0f})
        builder.add_triangle({at, at, at}, {at, std::abs(at - 1), at}, {at, at, std::abs(at - 1)});
    return builder;
}

class OctreeForms : public testing::TestWithParam<const char*> {
protected:
    std::string spec() const { return GetParam(); }
};

TEST_P(OctreeForms, test_all_objects_of_a_cell_and_keep_the_nearest) {
    for (const bool far_first : {false, true}) {
        GeometryBuilder builder = framed();
        for (const float z : {far_first ? 3.2f : 3.1f, far_first ? 3.1f : 3.2f})
            builder.add_triangle({3, 3, z}, {3.5f, 3, z}, {3, 3.5f, z});
        const Geometry geometry = std::move(builder).build();
        const Hit hit = nearest(*built(spec(), geometry), {.origin = {3.1f, 3.1f, 0}});
        EXPECT_EQ(hit.t, 3.1f);
        EXPECT_EQ(hit.primitive, far_first ? 3u : 2u);
    }
}

TEST_P(OctreeForms, count_a_hit_only_when_no_earlier_cell_can_hold_a_nearer_one) {
    GeometryBuilder builder = framed();
    // Slanted through the whole scene: it is among the first cell's objects, but is hit behind the
    // small one, which is not.
    builder.add_triangle({0.5f, 0.5f, 0.5f}, {15, 0.5f, 15}, {0.5f, 15, 15});
    builder.add_triangle({6, 6, 9}, {7, 6, 9}, {6, 7, 9});
    const Geometry geometry = std::move(builder).build();
    const Hit hit = nearest(*built(spec(), geometry), {.origin = {6.2f, 6.2f, 0}});
    EXPECT_EQ(hit.primitive, 3u);
}

TEST_P(OctreeForms, never_lose_objects_that_straddle_or_lie_in_a_boundary) {
    GeometryBuilder builder = framed();
    builder.add_triangle({2, 2, 8}, {14, 2, 8}, {2, 14, 8});  // lies in the middle plane
    builder.add_triangle({8, 1, 1}, {8, 15, 1}, {8, 1, 15});  // likewise, across another axis
    builder.add_triangle({7, 7, 4}, {9, 7, 4}, {7, 9, 4});    // straddles two planes
    const Geometry geometry = std::move(builder).build();
    const auto accel = built(spec(), geometry), truth = built("brute_force", geometry);
    for (const float x : {7.5f, 8.0f, 8.5f})
        for (const float z : {0.0f, 4.0f, 8.0f, 16.0f})
            for (const vec3& direction : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0),
                                          vec3(-1, -1, 0), vec3(1, 1, 1), vec3(0, 1, 0)}) {
                const Ray ray{.origin = {x, x, z}, .t_min = -20, .direction = direction};
                EXPECT_EQ(nearest(*accel, ray), nearest(*truth, ray)) << x << ' ' << z;
            }
}

TEST_P(OctreeForms, find_hits_from_so_far_away_that_they_are_reported_outside_their_cells) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> in(0, 16), by(-0.3f, 0.3f), turn(-1, 1);
    GeometryBuilder builder;
    for (int i = 0; i < 400; ++i) {
        const vec3 corner(in(random), in(random), in(random));
        builder.add_triangle(corner, corner + vec3(by(random), by(random), by(random)),
                             corner + vec3(by(random), by(random), by(random)));
    }
    const Geometry geometry = std::move(builder).build();
    const auto accel = built(spec(), geometry), truth = built("brute_force", geometry);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec3 to(in(random), in(random), in(random));
        const vec3 direction(turn(random), turn(random), turn(random));
        const Ray ray{.origin = to - 1e6f * direction, .direction = direction};
        const Hit hit = nearest(*truth, ray);
        hits += hit.primitive != no_primitive;
        ASSERT_EQ(nearest(*accel, ray), hit);
    }
    EXPECT_GT(hits, 20);
}

INSTANTIATE_TEST_SUITE_P(
    All, OctreeForms,
    testing::Values(
        "octree", "octree:overlap=bounds", "octree:overlap=exact,stop=count,leaf=1,depth=7",
        "octree:overlap=loose,leaf=1", "octree:overlap=exact,planes=sah,leaf=1",
        "octree:overlap=exact,traversal=parametric,stop=count,leaf=1,depth=7",
        "octree:overlap=exact,traversal=parametric,storage=linear,stop=count,leaf=1,depth=7",
        "octree:overlap=exact,traversal=glassner84,stop=count,leaf=1,depth=6",
        "octree:overlap=exact,traversal=samet89,stop=count,leaf=1,depth=6",
        "octree:traversal=recursive93,planes=sah,stop=count,leaf=1,depth=6"),
    [](const auto& spec) {
        std::string name = spec.param;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

/// Long and thin, all through the same few cells.
Geometry needles() {
    std::mt19937 random(9);
    std::uniform_real_distribution<float> in(0, 1);
    GeometryBuilder builder;
    for (int i = 0; i < 500; ++i) {
        const vec3 from(in(random), in(random), in(random)), to(in(random), in(random), in(random));
        builder.add_triangle(from, to, to + vec3(1e-3f, 0, 0));
    }
    return std::move(builder).build();
}

TEST(Octree, keeps_to_the_bound_on_references_and_says_so) {
    const Geometry geometry = needles();
    for (const int bound : {1, 4, 16}) {
        const Footprint footprint =
            built("octree:overlap=bounds,stop=count,leaf=1,bound=" + std::to_string(bound),
                  geometry)
                ->footprint();
        EXPECT_LE(*footprint.references, static_cast<std::uint64_t>(bound) * geometry.size());
        EXPECT_NE(footprint.remark.find("references are bounded by " + std::to_string(bound)),
                  std::string::npos);
    }
}

TEST(Octree, of_coincident_triangles_is_no_deeper_than_its_bound_allows) {
    GeometryBuilder builder = framed();
    for (int i = 0; i < 1000; ++i) builder.add_triangle({3, 3, 3}, {4, 3, 3}, {3, 4, 3});
    const Geometry geometry = std::move(builder).build();
    for (const char* spec : {"octree", "octree:overlap=bounds,stop=count,leaf=1"}) {
        const Footprint footprint = built(spec, geometry)->footprint();
        EXPECT_LE(*footprint.references, 16u * geometry.size()) << spec;
        EXPECT_LE(*footprint.interior, 16u * 20) << spec;
    }
}

TEST(Octree, that_is_loose_holds_each_object_once) {
    const Geometry geometry = needles();
    EXPECT_EQ(built("octree:overlap=loose,leaf=1", geometry)->footprint().references,
              geometry.size());
}

TEST(Octree, is_the_same_for_any_number_of_threads) {
    const Geometry geometry = needles();
    const auto counts = [&](std::size_t threads) {
        tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
        const auto accel = built("octree:overlap=exact,bound=100", geometry);
        const auto session = accel->open(Mode::counting);
        std::vector<Ray> rays(1000);
        for (std::size_t i = 0; i < rays.size(); ++i)
            rays[i] = {.origin = {float(i) / 1000, 0.5f, -1}, .direction = {0.1f, 0, 1}};
        std::vector<Hit> hits(rays.size());
        session->closest({.rays = rays}, hits);
        return std::pair(*accel->footprint().references, *session->counters(RayKind::secondary));
    };
    EXPECT_EQ(counts(1), counts(4));
}

TEST(Octree, refuses_options_that_do_not_go_together) {
    const Geometry geometry = needles();
    EXPECT_THROW(built("octree:storage=linear", geometry), std::invalid_argument);
    EXPECT_THROW(built("octree:overlap=loose,traversal=parametric", geometry),
                 std::invalid_argument);
    EXPECT_THROW(built("octree:leaves=single", geometry), std::invalid_argument);
    EXPECT_THROW(built("octree:traversal=samet89,planes=sah,storage=linear", geometry),
                 std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
