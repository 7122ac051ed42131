#include "accel/simd/watertight_block.h"
#include "tests/simd/hard_leaves.h"

/// Four watertight triangles and one ray, or one triangle and a ray a lane: what the shared test
/// answers, to the last bit.
namespace rayshoot {
namespace {

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

TEST(WatertightBlock, answers_like_the_shared_test_with_the_same_counts) {
    cases::Random random(1);
    std::size_t hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const HardLeaf hard(Mixture::triangles, Precision::watertight, random);
        const Geometry& geometry = hard.geometry;
        const std::uint32_t size = std::min(geometry.size(), 4u);
        TriangleBlock block;
        for (std::uint32_t j = 0; j < size; ++j) block.set(j, geometry.triangle(j), j);
        const Ray ray = cases::hard_ray(geometry, random.below(size), random);
        const Answer wanted = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
            for (std::uint32_t j = 0; j < size; ++j)
                test_primitive<Query::closest>(geometry, j, r, hit, count);
        });
        const Answer found = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
            test_watertight(block, TestRay(r, Precision::watertight), geometry.padding(), hit,
                            count);
        });
        ASSERT_TRUE(cases::same_bits(found.hit, wanted.hit)) << cases::print(ray);
        ASSERT_EQ(found.counts, wanted.counts) << cases::print(ray);
        hits += found.hit.primitive != no_primitive;
    }
    EXPECT_GT(hits, 5000u);
}

template <std::size_t Width>
void expect_lanes_like_rays() {
    using namespace simd;
    using V = Floats<Width>;
    constexpr auto tag = floats<Width>;
    cases::Random random(2);
    std::size_t hits = 0;
    for (int i = 0; i < 40000; ++i) {
        const HardLeaf hard(Mixture::triangles, Precision::watertight, random);
        const Geometry& geometry = hard.geometry;
        const cases::SideBySide<Width> wide(geometry, random);
        const Triangle triangle = geometry.triangle(0);
        const auto a = everywhere<Width>(triangle.a), b = everywhere<Width>(triangle.b),
                   c = everywhere<Width>(triangle.c);
        const WideShear<V> shear(wide.direction);
        const WideEdges<V> edges(shear.turned(a - wide.origin), shear.turned(b - wide.origin),
                                 shear.turned(c - wide.origin), shear.along_x, shear.along_y);
        const WideCrossing<V> at = edges.exact(shear.direction_z);
        const auto found = clamped<V>({at.t, hn::AndNot(edges.outside(), hn::Eq(at.t, at.t))}, a,
                                      triangle_bounds(a, b, c), wide.origin, wide.inverse,
                                      geometry.padding(), NeverStrays());
        const auto t = wide.store(found.t), u = wide.store(at.u), v = wide.store(at.v);
        for (std::size_t j = 0; j < Width; ++j) {
            const Answer wanted =
                cases::ask(wide.rays[j], [&](const Ray& r, Hit& hit, auto& count) {
                    test_primitive<Query::closest>(geometry, 0, r, hit, count);
                });
            const bool met = (bits(tag, found.met) >> j & 1) != 0;
            Hit hit = nothing_yet(wide.rays[j]);
            if (met) accept({t[j], 0, u[j], v[j]}, wide.rays[j].t_min, hit);
            ASSERT_TRUE(cases::same_bits(hit, wanted.hit)) << cases::print(wide.rays[j]);
            ASSERT_EQ(met, wanted.counts[Event::object_hit] == 1) << cases::print(wide.rays[j]);
            hits += met;
        }
    }
    EXPECT_GT(hits, 5000 * Width);
}

TEST(WideEdges, rays_side_by_side_meet_a_triangle_where_each_alone_does) {
    expect_lanes_like_rays<4>();
    expect_lanes_like_rays<8>();
    expect_lanes_like_rays<simd::widest>();
}

}  // namespace
}  // namespace rayshoot
