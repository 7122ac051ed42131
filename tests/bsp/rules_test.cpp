#include <gtest/gtest.h>

#include "accel/bsp/bsp.h"
#include "accel/bsp/general/general_bsp.h"
#include "accel/core/catalogue.h"
#include "accel/core/leaves.h"

#include <algorithm>

/// What every subdivision of space has to keep to, for every configuration of the BSP tree.
namespace rayshoot::bsp_test {
namespace {

class EveryTree : public testing::TestWithParam<std::string_view> {
protected:
    std::unique_ptr<Accel> tree(const Geometry& geometry) const {
        return build(built_in_catalogue(), GetParam(), {geometry});
    }
    /// The hit that brute force finds, and the same asked for alone and sixteen times at once.
    void expect_true_hit(const Geometry& geometry, const Ray& ray) const {
        Hit truth = nothing_yet(ray);
        Silent silent;
        for (std::uint32_t i = 0; i < geometry.size(); ++i)
            test_primitive<Query::closest>(geometry, i, ray, truth, silent);
        if (truth.primitive == no_primitive) truth = Hit{};
        const auto accel = tree(geometry);
        for (const std::size_t count : {1u, 16u}) {
            const std::vector<Ray> rays(count, ray);
            std::vector<Hit> hits(count);
            accel->open(Mode::timing)->closest({.rays = rays}, hits);
            for (const Hit& hit : hits) EXPECT_EQ(hit, truth);
        }
    }
};

/// A triangle across x that every ray along the x axis meets.
void add_wall(GeometryBuilder& builder, float x, float size = 1) {
    builder.add_triangle(vec3(x, -size, -size), vec3(x, 3 * size, -size), vec3(x, -size, 3 * size));
}

TEST_P(EveryTree, visits_cells_in_the_right_order) {
    GeometryBuilder builder;
    for (int i = 0; i < 200; ++i) add_wall(builder, static_cast<float>(i));
    const Geometry geometry = std::move(builder).build();
    const auto accel = tree(geometry);
    for (const float way : {1.0f, -1.0f}) {
        const Ray ray{{way > 0 ? -1.0f : 200.0f, 0.1f, 0.2f}, 0, {way, 0.001f, 0.002f}};
        std::vector<Hit> hits(1);
        const auto session = accel->open(Mode::counting);
        session->closest({.rays = std::span(&ray, 1)}, hits);
        EXPECT_EQ(hits[0].primitive, way > 0 ? 0u : 199u);
        // What is far behind the hit is never looked at: cells came in order.
        EXPECT_LE((*session->counters(RayKind::secondary))[Event::object_test],
                  geometry.size() / 3);
    }
}

TEST_P(EveryTree, tests_all_objects_of_a_cell_and_keeps_the_nearest) {
    for (const bool nearest_first : {true, false}) {
        GeometryBuilder builder;
        add_wall(builder, nearest_first ? 0.0f : 1e-5f);
        add_wall(builder, nearest_first ? 1e-5f : 0.0f);
        const Geometry geometry = std::move(builder).build();
        expect_true_hit(geometry, {{-1, 0, 0}, 0, {1, 0, 0}});
        expect_true_hit(geometry, {{1, 0, 0}, 0, {-1, 0, 0}});
    }
}

TEST_P(EveryTree, counts_a_hit_only_when_no_earlier_cell_can_hold_a_nearer_one) {
    // The large triangle is in nearly all cells, also in those before the small ones.
    GeometryBuilder builder;
    builder.add_triangle(vec3(0, -1, -1), vec3(100, 60, -1), vec3(0, -1, 80));
    for (int i = 1; i < 100; ++i) add_wall(builder, static_cast<float>(i), 0.4f);
    const Geometry geometry = std::move(builder).build();
    for (int i = 0; i < 60; ++i) {
        const float y = -0.4f + 0.02f * static_cast<float>(i);
        expect_true_hit(geometry, {{-1, y, 0.1f}, 0, {1, 0.004f, 0.001f}});
        expect_true_hit(geometry, {{101, y, 0.1f}, 0, {-1, 0.004f, 0.001f}});
    }
}

TEST_P(EveryTree, loses_no_object_that_straddles_a_boundary_or_lies_in_it) {
    GeometryBuilder builder;
    for (int i = 0; i <= 16; ++i) {
        const auto at = static_cast<float>(i);
        builder.add_triangle(vec3(at, 0, 0), vec3(at, 16, 0), vec3(at, 0, 16));
        builder.add_triangle(vec3(0, at, 0), vec3(16, at, 0), vec3(0, at, 16));
        builder.add_triangle(vec3(0, 0, at), vec3(16, 0, at), vec3(0, 16, at));
    }
    const Geometry geometry = std::move(builder).build();
    for (int i = 0; i <= 16; ++i)
        for (const float beside : {0.0f, 0.25f}) {
            const auto at = static_cast<float>(i);
            // Along the walls, within their planes or beside them, and across them.
            for (const float zero : {0.0f, -0.0f}) {
                expect_true_hit(geometry, {{-1, at, 1 + beside}, 0, {1, zero, zero}});
                expect_true_hit(geometry, {{at, 17, 1 + beside}, 0, {zero, -1, zero}});
                expect_true_hit(geometry, {{at, beside, -1}, 0, {zero, zero, 1}});
            }
            expect_true_hit(geometry, {{at, at, -1}, 0, {-0.01f, 0.02f, 1}});
            expect_true_hit(geometry, {{8, 8, 8}, 0, {at - 8, beside, 1}});
        }
}

std::string name_of(const testing::TestParamInfo<std::string_view>& spec) {
    std::string name(spec.param);
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}
INSTANTIATE_TEST_SUITE_P(Bsp, EveryTree, testing::ValuesIn(Bsp::configurations), name_of);
INSTANTIATE_TEST_SUITE_P(GeneralBsp, EveryTree, testing::ValuesIn(GeneralBsp::configurations),
                         name_of);

}  // namespace
}  // namespace rayshoot::bsp_test
