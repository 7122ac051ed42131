#include <gtest/gtest.h>

#include "accel/bsp/clipper.h"
#include "accel/core/catalogue.h"
#include "tests/bsp/scenes.h"

#include <random>

namespace rayshoot::bsp_test {
namespace {

std::vector<Ray> random_rays(std::size_t count, float from) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> place(0, 1);
    const auto point = [&] {
        const float x = place(random), y = place(random), z = place(random);
        return vec3(x, y, z);
    };
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 origin = vec3(0.5f) + from * (point() - vec3(0.5f));
        rays.push_back({origin, 0, point() - origin});
    }
    return rays;
}

struct Traced {
    std::vector<Hit> hits;
    Counters counters;

    std::uint64_t full_cells() const { return counters[Event::cell] - counters[Event::empty_cell]; }
};
Traced traced(const Geometry& geometry, std::string_view spec, std::span<const Ray> rays) {
    const auto accel = build(built_in_catalogue(), spec, {geometry});
    const auto session = accel->open(Mode::counting);
    Traced all{std::vector<Hit>(rays.size()), {}};
    session->closest({.rays = rays}, all.hits);
    all.counters = *session->counters(RayKind::secondary);
    return all;
}

TEST(BspTraversals, visit_the_same_cells_that_hold_anything) {
    for (const float size : {0.02f, 0.3f}) {
        const Geometry geometry = random_triangles(3000, size, 11);
        const std::vector<Ray> rays = random_rays(3000, 1);
        const Traced alone = traced(geometry, "bsp:packets=off,flight=1", rays);
        for (const std::string_view spec : {"bsp:packets=off", "bsp:packets=off,flight=64",
                                            "bsp:traversal=short_stack", "bsp:traversal=ropes"}) {
            SCOPED_TRACE(spec);
            const Traced other = traced(geometry, spec, rays);
            EXPECT_EQ(other.hits, alone.hits);
            EXPECT_EQ(other.counters[Event::object_test], alone.counters[Event::object_test]);
            EXPECT_EQ(other.full_cells(), alone.full_cells());
            EXPECT_LE(other.counters[Event::cell], alone.counters[Event::cell]);
        }
    }
}

TEST(BspTraversals, find_what_rays_from_far_away_hit_without_testing_everything) {
    const Geometry geometry = random_triangles(20000, 0.02f, 12);
    const std::vector<Ray> rays = random_rays(300, 1e5f);
    const Traced far = traced(geometry, "bsp:overlap=exact", rays);
    EXPECT_EQ(far.hits, traced(geometry, "brute_force", rays).hits);
    EXPECT_LT(far.counters[Event::object_test], rays.size() * geometry.size() / 4);
}

TEST(BspClipper, encloses_the_part_of_a_primitive_in_a_cell) {
    std::mt19937 random(6);
    std::uniform_real_distribution<float> place(0, 1);
    for (const float size : {0.05f, 1.0f}) {
        const Geometry geometry = random_triangles(300, size, 13);
        const Membership membership({geometry}, Overlap::exact);
        const Clipper clipper(geometry, membership);
        for (std::uint32_t i = 0; i < geometry.size(); ++i)
            for (int j = 0; j < 50; ++j) {
                Box cell;
                const vec3 corner(place(random), place(random), place(random));
                const Box whole = geometry.bounds(i);
                cell.include(whole.lo + corner * whole.size());
                cell.include(whole.lo + place(random) * whole.size());
                const Box part = membership.clipped(i, cell), ours = clipper.clipped(i, cell);
                EXPECT_TRUE(part.empty() || ours.contains(part));
                // ... and not much more.
                const Box more = membership.clipped(i, cell.grown(0x1p-12f)).grown(0x1p-12f);
                EXPECT_TRUE(ours.empty() || more.contains(ours));
            }
    }
}

}  // namespace
}  // namespace rayshoot::bsp_test
