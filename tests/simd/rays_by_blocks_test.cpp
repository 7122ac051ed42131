#include "accel/simd/rays_by_blocks.h"
#include "tests/simd/hard_leaves.h"

/// Several rays, each against a block of its own: what the shared test answers, to the last bit.
namespace rayshoot {
namespace {

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

/// Some primitives of a geometry, as a block and for the shared test.
struct Block {
    std::vector<std::uint32_t> members;
    TriangleBlock block;

    Block(const Geometry& geometry, cases::Random& random) {
        const std::uint32_t size = 1 + random.below(TriangleBlock::width);
        for (std::uint32_t i = 0; i < size; ++i) {
            members.push_back(random.below(geometry.size()));
            block.set(i, geometry.triangle(members.back()), members.back());
        }
    }
};

template <Precision P>
void expect_like_the_shared_test() {
    cases::Random random(1);
    Counters counts, wanted_counts;
    Tally tally{&counts};
    for (int i = 0; i < 20000; ++i) {
        const HardLeaf hard(Mixture::triangles, P, random);
        const Geometry& geometry = hard.geometry;
        const std::size_t size = 1 + random.below(rays_by_blocks);
        std::vector<Ray> rays;
        std::vector<Block> blocks;
        for (std::size_t j = 0; j < size; ++j) {
            blocks.emplace_back(geometry, random);
            const std::uint32_t target = random.below(geometry.size());
            rays.push_back(cases::hard_ray(geometry, target, random));
        }
        for (int round = 0; round < 6; ++round) {
            RaysAndBlocks pairs;
            std::vector<TestRay> prepared;
            std::vector<Hit> found;
            for (const Ray& ray : rays) {
                prepared.emplace_back(ray, P);
                found.push_back(nothing_yet(ray));
            }
            for (std::size_t j = 0; j < size; ++j)
                pairs[j] = {&prepared[j], &found[j], &blocks[j].block};
            test<P>(pairs, size, geometry.padding(), tally);
            for (std::size_t j = 0; j < size; ++j) {
                const Answer wanted =
                    cases::ask(rays[j], [&](const Ray& ray, Hit& hit, auto& count) {
                        for (const std::uint32_t primitive : blocks[j].members)
                            test_primitive<Query::closest>(geometry, primitive, ray, hit, count);
                    });
                wanted_counts += wanted.counts;
                ASSERT_TRUE(cases::same_bits(found[j], wanted.hit)) << cases::print(rays[j]);
                // In the next round, up to the hit.
                if (wanted.hit.primitive != no_primitive)
                    rays[j] = cases::ending_near(rays[j], wanted.hit.t, random);
                else rays[j] = cases::hard_ray(geometry, random.below(geometry.size()), random);
            }
            ASSERT_EQ(counts, wanted_counts);
        }
    }
    EXPECT_GT(counts[Event::object_test], 100000 * rays_by_blocks);
    EXPECT_GT(counts[Event::object_hit], counts[Event::object_test] / 10);
}

TEST(RaysByBlocks, answer_like_the_shared_test) {
    expect_like_the_shared_test<Precision::standard>();
}

TEST(RaysByBlocks, answer_like_the_shared_test_of_watertight_triangles) {
    expect_like_the_shared_test<Precision::watertight>();
}

}  // namespace
}  // namespace rayshoot
