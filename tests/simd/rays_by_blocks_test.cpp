#include "accel/simd/rays_by_blocks.h"
#include "tests/simd/hard_leaves.h"

/// Several rays, each against a block of its own: what the shared test answers, to the last bit.
namespace rayshoot {
namespace {

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

void set(TriangleBlock& block, std::size_t lane, const Geometry& geometry, std::uint32_t i) {
    block.set(lane, geometry.triangle(i), i);
}
void set(SphereBlock& block, std::size_t lane, const Geometry& geometry, std::uint32_t i) {
    block.set(lane, geometry.sphere(i), i);
}

/// Some primitives of a geometry, as a block and for the shared test.
template <class Block>
struct Members {
    std::vector<std::uint32_t> numbers;
    Block block;

    Members(const Geometry& geometry, cases::Random& random) {
        const std::uint32_t size = 1 + random.below(Block::width);
        for (std::uint32_t lane = 0; lane < size; ++lane) {
            numbers.push_back(random.below(geometry.size()));
            set(block, lane, geometry, numbers.back());
        }
    }
};

/// test(pairs, size, padding, count); for Query::occluded only whether there is a hit is compared.
template <class Block, Query Q = Query::closest, class Test>
void expect_like_the_shared_test(Mixture mixture, Precision precision, Test&& test) {
    cases::Random random(1);
    Counters counts, wanted_counts;
    Tally tally{&counts};
    for (int i = 0; i < 20000; ++i) {
        const HardLeaf hard(mixture, precision, random);
        const Geometry& geometry = hard.geometry;
        const std::size_t size = 1 + random.below(rays_by_blocks);
        std::vector<Ray> rays;
        std::vector<Members<Block>> members;
        const auto some_ray = [&] {
            const std::uint32_t target = random.below(geometry.size());
            return cases::hard_ray(geometry, target, random);
        };
        for (std::size_t j = 0; j < size; ++j) {
            members.emplace_back(geometry, random);
            rays.push_back(some_ray());
        }
        for (int round = 0; round < 6; ++round) {
            RaysAndBlocks<Block> pairs;
            std::vector<TestRay> prepared;
            std::vector<Hit> found;
            for (const Ray& ray : rays) {
                prepared.emplace_back(ray, precision);
                found.push_back(nothing_yet(ray));
            }
            for (std::size_t j = 0; j < size; ++j)
                pairs[j] = {&prepared[j], &found[j], &members[j].block};
            test(pairs, size, geometry.padding(), tally);
            for (std::size_t j = 0; j < size; ++j) {
                const Answer wanted =
                    cases::ask(rays[j], [&](const Ray& ray, Hit& hit, auto& count) {
                        for (const std::uint32_t number : members[j].numbers)
                            test_primitive<Query::closest>(geometry, number, ray, hit, count);
                    });
                wanted_counts += wanted.counts;
                const bool hit = wanted.hit.primitive != no_primitive;
                ASSERT_TRUE(Q == Query::closest ? cases::same_bits(found[j], wanted.hit)
                                                : hit == (found[j].primitive != no_primitive))
                    << cases::print(rays[j]);
                rays[j] = hit ? cases::ending_near(rays[j], wanted.hit.t, random) : some_ray();
            }
            ASSERT_EQ(counts, wanted_counts);
        }
    }
    EXPECT_GT(counts[Event::object_test], 100000 * rays_by_blocks);
    EXPECT_GT(counts[Event::object_hit], counts[Event::object_test] / 10);
}

template <Precision P, Query Q = Query::closest>
void expect_triangles_like_the_shared_test() {
    expect_like_the_shared_test<TriangleBlock, Q>(
        Mixture::triangles, P, [](auto& pairs, std::size_t size, float padding, auto& count) {
            constexpr Misses misses = Q == Query::closest ? Misses::go_on : Misses::leave;
            test<P, misses, Q>(pairs, size, padding, count);
        });
}

TEST(RaysByBlocks, answer_like_the_shared_test) {
    expect_triangles_like_the_shared_test<Precision::standard>();
}

TEST(RaysByBlocks, answer_like_the_shared_test_of_watertight_triangles) {
    expect_triangles_like_the_shared_test<Precision::watertight>();
}

TEST(RaysByBlocks, are_occluded_where_the_shared_test_hits) {
    expect_triangles_like_the_shared_test<Precision::standard, Query::occluded>();
    expect_triangles_like_the_shared_test<Precision::watertight, Query::occluded>();
}

TEST(RaysByBlocks, answer_like_the_shared_test_of_spheres) {
    expect_like_the_shared_test<SphereBlock>(
        Mixture::spheres, Precision::standard,
        [](auto& pairs, std::size_t size, float padding, auto& count) {
            test(pairs, size, padding, count);
        });
}

}  // namespace
}  // namespace rayshoot
