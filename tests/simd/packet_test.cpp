#include "accel/bvh8/packet.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

/// A packet's rays answer like single rays; its beam misses nothing that one of them meets.
namespace rayshoot {
namespace {

std::vector<Ray> rays_about(const vec3& towards, float spread, float apart, cases::Random& random) {
    const vec3 origin = random.in_cube(3);
    std::vector<Ray> rays(Packet::most);
    for (Ray& ray : rays) {
        ray.origin = origin + random.in_cube(apart);
        ray.direction = towards - origin + random.in_cube(spread);
        ray.t_min = static_cast<float>(random.uniform(-0.5, 0.5));
        ray.t_max = static_cast<float>(random.uniform(0.6, 2));
    }
    return rays;
}

/// Asks until the rays make a packet.
std::vector<Ray> some_packet(Packet& packet, const vec3& towards, cases::Random& random) {
    while (true) {
        const std::vector<Ray> rays = rays_about(towards, 0.1f, 0.01f, random);
        if (packet.load(rays)) return rays;
    }
}

TEST(Packet, beam_meets_every_box_that_a_ray_meets) {
    cases::Random random(1);
    Packet packet;
    std::size_t met = 0, missed = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::vector<Ray> rays = some_packet(packet, vec3(0), random);
        Boxes<8> boxes;
        std::array<Box, 8> each;
        for (std::size_t j = 0; j < 8; ++j) {
            each[j].include(random.in_cube(1.0));
            each[j].include(each[j].lo + random.in_cube(0.3));
            boxes.set(j, each[j]);
        }
        const auto [entry, exit] = packet.beam(packet.all()).clip(boxes);
        std::array<float, 8> entries, exits;
        simd::hn::StoreU(entry, simd::floats<8>, entries.data());
        simd::hn::StoreU(exit, simd::floats<8>, exits.data());
        for (std::size_t j = 0; j < 8; ++j) {
            bool any = false;
            for (const Ray& ray : rays) {
                const Interval own = clip(SlabRay(ray.origin, ray.direction), each[j],
                                          {ray.t_min, float_below(ray.t_max)});
                if (own.empty()) continue;
                any = true;
                ASSERT_LE(entries[j], own.entry) << cases::print(ray);
                ASSERT_GE(exits[j], own.exit) << cases::print(ray);
            }
            met += any;
            missed += !(entries[j] <= exits[j]);
        }
    }
    EXPECT_GT(met, 1000u);
    EXPECT_GT(missed, 1000u);
}

TEST(Packet, rays_answer_like_single_rays) {
    cases::Random random(2);
    Packet packet;
    std::size_t hits = 0;
    for (int i = 0; i < 3000; ++i) {
        const Triangle triangle = cases::triangle(random);
        const std::vector<Ray> rays = some_packet(packet, triangle.a, random);
        const Geometry geometry = cases::alone(triangle);
        TriangleBlock block;
        block.set(0, triangle, 0);
        Boxes<1> box;
        box.set(0, geometry.bounds(0));
        Counters counts, wanted_counts;
        Tally tally{&counts}, wanted_tally{&wanted_counts};
        for (std::size_t group = 0; group < packet.all().end(); ++group)
            packet.test<Query::closest>(group, packet.meets(group, box, 0), block,
                                        geometry.padding(), tally);
        for (std::size_t j = 0; j < rays.size(); ++j) {
            Hit wanted = nothing_yet(rays[j]);
            if (!clip(SlabRay(rays[j].origin, rays[j].direction), geometry.bounds(0),
                      {rays[j].t_min, wanted.t})
                     .empty())
                test_primitive<Query::closest>(geometry, 0, rays[j], wanted, wanted_tally);
            const Hit found = packet.hit(j);
            ASSERT_EQ(std::memcmp(&found, &wanted, sizeof(Hit)), 0) << cases::print(rays[j]);
            hits += found.primitive != no_primitive;
        }
        ASSERT_EQ(counts, wanted_counts);
    }
    EXPECT_GT(hits, 10000u);
}

TEST(Packet, is_not_made_of_rays_that_go_different_ways) {
    cases::Random random(3);
    Packet packet;
    for (int i = 0; i < 1000; ++i) EXPECT_FALSE(packet.load(rays_about(vec3(0), 100, 0, random)));
    std::vector<Ray> straight(Packet::group, Ray{vec3(0), 0, vec3(0, 0, 1)});
    EXPECT_FALSE(packet.load(straight)) << "zeros have two signs";
}

}  // namespace
}  // namespace rayshoot
