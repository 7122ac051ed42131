#include "accel/core/catalogue.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <cstring>

/// Every way through the 8-wide tree on rays that suit none: packets so wide that they are given
/// up.
namespace rayshoot {
namespace {

Geometry many_small_triangles() {
    cases::Random random(1);
    GeometryBuilder builder;
    for (int i = 0; i < 20000; ++i) {
        const vec3 place = random.in_cube(1);
        const std::uint32_t first = builder.add_vertex(place);
        builder.add_vertex(place + random.in_cube(0.02));
        builder.add_vertex(place + random.in_cube(0.02));
        builder.add_triangle({first, first + 1, first + 2});
    }
    return std::move(builder).build(Precision::standard);
}

std::vector<Ray> wide_packets() {
    cases::Random random(2);
    std::vector<Ray> rays(4096);
    for (Ray& ray : rays) {
        ray.origin = vec3(3) + random.in_cube(0.2);
        ray.direction = vec3(-3) + random.in_cube(0.3);
    }
    return rays;
}

class Ways : public testing::TestWithParam<const char*> {};

TEST_P(Ways, answer_like_the_scalar_tree) {
    const Geometry geometry = many_small_triangles();
    const std::vector<Ray> rays = wide_packets();
    const BuildInput input{geometry};
    const auto scalar = build(built_in_catalogue(), "bvh", input);
    const auto tested = build(built_in_catalogue(), GetParam(), input);
    const auto truth = scalar->open(Mode::timing), session = tested->open(Mode::counting);
    std::vector<Hit> wanted(rays.size()), found(rays.size());
    std::vector<std::uint8_t> wanted_any(rays.size()), any(rays.size());
    const RayBatch batch{RayKind::secondary, 1, rays};
    truth->closest(batch, wanted);
    session->closest(batch, found);
    truth->occluded(batch, wanted_any);
    session->occluded(batch, any);
    EXPECT_EQ(std::memcmp(found.data(), wanted.data(), found.size() * sizeof(Hit)), 0);
    EXPECT_EQ(any, wanted_any);
    const Counters& counted = *session->counters(RayKind::secondary);
    EXPECT_GT(counted[Event::hit], 1000u);
    // More steps than 64 a packet can take: they were given up, and their rays went on alone.
    EXPECT_GT(counted[Event::step], 2 * rays.size());
}

INSTANTIATE_TEST_SUITE_P(Bvh8, Ways,
                         testing::Values("bvh8", "bvh8:flight=1", "bvh8:flight=16",
                                         "bvh8:packets=off,flight=64"));

}  // namespace
}  // namespace rayshoot
