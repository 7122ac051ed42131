#include "accel/simd/packet.h"
#include "accel/simd/leaf_packer.h"
#include "accel/simd/quantised_boxes.h"
#include "tests/simd/hard_leaves.h"

/// A packet's rays answer like single rays; its beam misses nothing that one of them meets.
namespace rayshoot {
namespace {

constexpr float anywhere = infinity;  ///< origins may be as far apart as they like

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
        if (packet.load(rays, Precision::standard, anywhere)) return rays;
    }
}

/// Some boxes by the way; one is unbounded along an axis, one begins where a ray does.
std::array<Box, 8> boxes_near(const vec3& origin, cases::Random& random) {
    std::array<Box, 8> boxes;
    for (Box& box : boxes) {
        box.include(random.in_cube(1.0));
        box.include(box.lo + random.in_cube(0.3));
    }
    const int axis = static_cast<int>(random.below(3));
    boxes[0].hi[axis] = infinity;
    boxes[1].lo[axis] = origin[axis];
    boxes[1].hi[axis] = std::max(origin[axis], boxes[1].hi[axis]);
    return boxes;
}

template <class Bounds>
void expect_beam_misses_nothing() {
    cases::Random random(1);
    Packet packet;
    std::size_t met = 0, missed = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::vector<Ray> rays = some_packet(packet, vec3(0), random);
        const std::array<Box, 8> each = boxes_near(rays[5].origin, random);
        Boxes<8> boxes;
        for (std::size_t j = 0; j < 8; ++j) boxes.set(j, each[j]);
        const auto [entry, exit] = packet.beam(packet.all()).clip(Bounds(boxes));
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

TEST(Packet, beam_meets_every_box_that_a_ray_meets) {
    expect_beam_misses_nothing<Boxes<8>>();
    expect_beam_misses_nothing<QuantisedBoxes>();
}

/// A component so small that its inverse is infinite would give NaN for planes through the origin.
TEST(Packet, is_not_made_of_rays_whose_inverse_is_infinite) {
    cases::Random random(3);
    Packet packet;
    for (int i = 0; i < 100; ++i) {
        std::vector<Ray> rays = some_packet(packet, vec3(0), random);
        const int axis = static_cast<int>(random.below(3));
        for (Ray& ray : rays) ray.direction[axis] = random.below(2) == 0 ? 1e-40f : 2e-40f;
        EXPECT_FALSE(packet.load(rays, Precision::standard, anywhere));
    }
}

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

/// A leaf whose primitives a packet tests together, and what Leaves says of them.
class Judged {
public:
    Judged(const HardLeaf& hard, std::uint32_t size)
        : order_(hard.members), range_{0, size}, leaves_(hard.geometry, order_, {&range_, 1}) {}

    /// Asks Leaves about each ray, and the packet by test(rays, count) about all; counts the pairs
    /// that were tested.
    template <Query Q, class Test>
    void expect_same(Packet& packet, std::span<const Ray> rays, std::vector<Hit>& hits,
                     Test&& test) {
        Counters counts, wanted_counts;
        Tally tally{&counts};
        // In two sets, so that some registers are not full.
        const RaySet some = 0x123456789abcdef0;
        test(some, tally);
        test(~some, tally);
        hits.clear();
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Answer wanted = cases::ask(rays[i], [&](const Ray& ray, Hit& hit, auto& count) {
                leaves_.test<Q>(range_, leaves_.prepared(ray), hit, count);
            });
            wanted_counts += wanted.counts;
            hits.push_back(wanted.hit);
            const Hit found = packet.hit(i);
            const bool same = Q == Query::closest ? cases::same_bits(found, wanted.hit)
                                                  : (found.primitive == no_primitive) ==
                                                        (wanted.hit.primitive == no_primitive);
            ASSERT_TRUE(same) << cases::print(rays[i]);
        }
        if constexpr (Q == Query::closest) {
            ASSERT_EQ(counts, wanted_counts);
        }
        tests += counts[Event::object_test];
        met += counts[Event::object_hit];
    }

    static inline std::uint64_t tests = 0, met = 0;

private:
    std::vector<std::uint32_t> order_;
    LeafRange range_;
    Leaves leaves_;
};

/// test(packet, rays, leaf of the first `most` members, query, count), in many packets.
template <class Test>
void expect_like_leaves(Mixture mixture, Precision precision, std::uint32_t most, int packets,
                        Test&& test) {
    cases::Random random(2);
    Judged::tests = Judged::met = 0;
    Packet packet;
    int made = 0;
    for (int i = 0; i < packets; ++i) {
        const HardLeaf hard(mixture, precision, random);
        const std::uint32_t size = std::min(hard.geometry.size(), most);
        const std::uint32_t target = hard.members[random.below(size)];
        std::vector<Ray> rays = cases::hard_packet(hard.geometry, target, Packet::most, random);
        if (!packet.load(rays, precision, anywhere)) continue;
        ++made;
        const auto members = std::span(hard.members).first(size);
        Judged judged(hard, size);
        std::vector<Hit> hits;
        const auto ask = [&]<Query Q>(std::integral_constant<Query, Q> query) {
            judged.expect_same<Q>(packet, rays, hits, [&](RaySet some, auto& count) {
                test(packet, some, hard.geometry, members, query, count);
            });
        };
        ask(std::integral_constant<Query, Query::closest>());
        if (testing::Test::HasFatalFailure()) return;
        for (std::size_t j = 0; j < rays.size(); ++j)
            if (hits[j].primitive != no_primitive)
                rays[j] = cases::ending_near(rays[j], hits[j].t, random);
        ASSERT_TRUE(packet.load(rays, precision, anywhere));
        ask(std::integral_constant<Query, Query::closest>());
        ASSERT_TRUE(packet.load(rays, precision, anywhere));
        ask(std::integral_constant<Query, Query::occluded>());
        if (testing::Test::HasFatalFailure()) return;
    }
    EXPECT_GT(made, packets / 4);
    EXPECT_GT(Judged::tests, 1000000u);
    EXPECT_GT(Judged::met, Judged::tests / 20);
}

template <Precision P>
void expect_triangles_like_leaves() {
    expect_like_leaves(Mixture::triangles, P, TriangleBlock::width, 8000,
                       [](Packet& packet, RaySet rays, const Geometry& geometry,
                          std::span<const std::uint32_t> members, auto query, auto& count) {
                           TriangleBlock block;
                           for (std::size_t i = 0; i < members.size(); ++i)
                               block.set(i, geometry.triangle(members[i]), members[i]);
                           packet.test<query(), P>(rays, block, geometry.padding(), count);
                       });
}

TEST(Packet, meets_triangles_where_each_ray_does) {
    expect_triangles_like_leaves<Precision::standard>();
}

TEST(Packet, meets_watertight_triangles_where_each_ray_does) {
    expect_triangles_like_leaves<Precision::watertight>();
}

TEST(Packet, meets_spheres_where_each_ray_does) {
    expect_like_leaves(Mixture::spheres, Precision::standard, SphereBlock::width, 8000,
                       [](Packet& packet, RaySet rays, const Geometry& geometry,
                          std::span<const std::uint32_t> members, auto query, auto& count) {
                           SphereBlock block;
                           for (std::size_t i = 0; i < members.size(); ++i)
                               block.set(i, geometry.sphere(members[i]), members[i]);
                           packet.test<query()>(rays, block, geometry.padding(), count);
                       });
}

TEST(Packet, meets_anything_ray_by_ray) {
    expect_like_leaves(Mixture::anything, Precision::watertight, 8, 4000,
                       [](Packet& packet, RaySet rays, const Geometry& geometry,
                          std::span<const std::uint32_t> members, auto query, auto& count) {
                           LeafPacker packer(geometry);
                           const PackedLeaf leaf = packer.add(members);
                           const PackedLeaves leaves = std::move(packer).build();
                           packet.test_each<query()>(rays, [&](const TestRay& ray, Hit& hit) {
                               leaves.test<query()>(leaf, ray, hit, count);
                           });
                       });
}

TEST(Packet, is_not_made_of_rays_that_begin_all_over_the_place) {
    Packet packet;
    std::vector<Ray> rays(Packet::group, Ray{vec3(0), 0, vec3(0.5f, 1, 1.1f)});
    rays[3].origin.y = 2;
    EXPECT_TRUE(packet.load(rays, Precision::standard, 2));
    EXPECT_FALSE(packet.load(rays, Precision::standard, 1.9f));
}

TEST(Packet, is_not_made_of_rays_that_go_different_ways) {
    cases::Random random(3);
    Packet packet;
    for (int i = 0; i < 1000; ++i)
        EXPECT_FALSE(
            packet.load(rays_about(vec3(0), 100, 0, random), Precision::standard, anywhere));
    std::vector<Ray> straight(Packet::group, Ray{vec3(0), 0, vec3(0, 0, 1)});
    EXPECT_FALSE(packet.load(straight, Precision::standard, anywhere)) << "zeros have two signs";
}

}  // namespace
}  // namespace rayshoot
