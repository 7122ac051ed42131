#include "accel/simd/sphere_block.h"
#include "tests/simd/hard_leaves.h"

/// Eight spheres and one ray, or one sphere and a ray a lane: what the shared test answers, to the
/// last bit.
namespace rayshoot {
namespace {

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

/// The first `size` spheres of a geometry, as one block.
SphereBlock block_of(const Geometry& geometry, std::uint32_t size) {
    SphereBlock block;
    for (std::uint32_t i = 0; i < size; ++i) block.set(i, geometry.sphere(i), i);
    return block;
}

/// Gives back the hit.
Hit expect_like_the_shared_test(const Geometry& geometry, std::uint32_t size, const Ray& ray) {
    const Answer wanted = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
        for (std::uint32_t i = 0; i < size; ++i)
            test_primitive<Query::closest>(geometry, i, r, hit, count);
    });
    const SphereBlock block = block_of(geometry, size);
    const Answer found = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
        test(block, TestRay(r, geometry.precision()), geometry.padding(), hit, count);
    });
    EXPECT_TRUE(cases::same_bits(found.hit, wanted.hit)) << cases::print(ray);
    EXPECT_EQ(found.counts, wanted.counts) << cases::print(ray);
    return found.hit;
}

TEST(SphereBlock, answers_like_the_shared_test_with_the_same_counts) {
    cases::Random random(1);
    std::size_t hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const HardLeaf hard(Mixture::spheres, Precision::standard, random);
        const std::uint32_t size = std::min(hard.geometry.size(), 8u);
        const Ray ray = cases::hard_ray(hard.geometry, random.below(size), random);
        const Hit hit = expect_like_the_shared_test(hard.geometry, size, ray);
        hits += hit.primitive != no_primitive;
    }
    EXPECT_GT(hits, 5000u);
}

/// The first root is 0 / 0, the second 0.
TEST(SphereBlock, is_hit_by_a_tangent_that_starts_where_it_touches) {
    const Geometry geometry = cases::alone(Sphere{vec3(0), 1});
    const Ray ray{vec3(1, 0, 0), -1, vec3(0, 1, 0)};
    EXPECT_EQ(expect_like_the_shared_test(geometry, 1, ray), (Hit{0, 0, 0, 0}));
}

TEST(SphereBlock, gives_back_the_spheres_it_was_given) {
    SphereBlock block;
    EXPECT_EQ(block.live(), 0u);
    for (std::uint32_t i = 0; i < 5; ++i) block.set(i, {vec3(1, 2, static_cast<float>(i)), 7}, i);
    EXPECT_EQ(block.live(), 5u);
    EXPECT_EQ(block.sphere(3).centre, vec3(1, 2, 3));
    EXPECT_EQ(block.sphere(3).radius, 7);
}

template <std::size_t Width>
void expect_lanes_like_rays() {
    using namespace simd;
    using V = Floats<Width>;
    constexpr auto tag = floats<Width>;
    cases::Random random(2);
    std::size_t hits = 0;
    for (int i = 0; i < 40000; ++i) {
        const HardLeaf hard(Mixture::spheres, Precision::standard, random);
        const Geometry& geometry = hard.geometry;
        const cases::SideBySide<Width> wide(geometry, random);
        const auto centre = everywhere<Width>(geometry.sphere(0).centre);
        const V radius = hn::Set(tag, geometry.sphere(0).radius);
        const WideRoots<V> sphere(centre, radius, wide.origin, wide.direction);
        const auto trusted = sphere.trusted(wide.direction_size);
        const auto found = clamped<V>({sphere.roots(), hn::And(trusted, sphere.met())}, centre,
                                      radius, wide.origin, wide.inverse, geometry.padding());
        const auto first = wide.store(found.t[0]), second = wide.store(found.t[1]);
        for (std::size_t j = 0; j < Width; ++j) {
            if ((bits(tag, trusted) >> j & 1) == 0) continue;
            const Answer wanted =
                cases::ask(wide.rays[j], [&](const Ray& r, Hit& hit, auto& count) {
                    test_primitive<Query::closest>(geometry, 0, r, hit, count);
                });
            const bool met = (bits(tag, found.met) >> j & 1) != 0;
            Hit hit = nothing_yet(wide.rays[j]);
            if (met) accept({first[j], 0, 0, 0}, wide.rays[j].t_min, hit);
            if (met) accept({second[j], 0, 0, 0}, wide.rays[j].t_min, hit);
            ASSERT_TRUE(cases::same_bits(hit, wanted.hit)) << cases::print(wide.rays[j]);
            ASSERT_EQ(met, wanted.counts[Event::object_hit] == 1) << cases::print(wide.rays[j]);
            hits += met;
        }
    }
    EXPECT_GT(hits, 5000 * Width);
}

TEST(WideRoots, rays_side_by_side_meet_a_sphere_where_each_alone_does) {
    expect_lanes_like_rays<4>();
    expect_lanes_like_rays<8>();
    expect_lanes_like_rays<simd::widest>();
}

}  // namespace
}  // namespace rayshoot
