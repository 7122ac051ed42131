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

/// t, u and v of one ray; t is NaN where there is no crossing, as in WideCrossing.
std::array<float, 3> scalar_crossing(const Triangle& triangle, const Ray& ray) {
    std::array<float, 3> crossing{std::numeric_limits<float>::quiet_NaN(), 0, 0};
    intersect_watertight(triangle, TestRay(ray, Precision::watertight),
                         [&](float t, float u, float v) {
                             crossing = {t, u, v};
                         });
    return crossing;
}

template <std::size_t Width>
void expect_lanes_like_rays() {
    using namespace simd;
    using V = Floats<Width>;
    constexpr auto tag = floats<Width>;
    cases::Random random(2);
    std::size_t met = 0;
    for (int i = 0; i < 40000; ++i) {
        const HardLeaf hard(Mixture::triangles, Precision::watertight, random);
        const Triangle triangle = hard.geometry.triangle(0);
        std::array<Ray, Width> rays;
        std::array<std::array<float, Width>, 6> rows;
        for (std::size_t j = 0; j < Width; ++j) {
            rays[j] = cases::hard_ray(hard.geometry, 0, random);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                rows[axis][j] = rays[j].origin[static_cast<int>(axis)];
                rows[axis + 3][j] = rays[j].direction[static_cast<int>(axis)];
            }
        }
        const auto row = [&](std::size_t n) { return hn::LoadU(tag, rows[n].data()); };
        const Vectors<V> origin{row(0), row(1), row(2)};
        const WideShear<V> shear({row(3), row(4), row(5)});
        const auto seen = [&](const vec3& p) {
            return shear.turned(everywhere<Width>(p) - origin);
        };
        const WideEdges<V> edges(seen(triangle.a), seen(triangle.b), seen(triangle.c),
                                 shear.along_x, shear.along_y);
        const std::uint32_t outside = bits(tag, edges.outside());
        const WideCrossing<V> crossing = edges.exact(shear.direction_z);
        std::array<std::array<float, Width>, 3> found;
        hn::StoreU(crossing.t, tag, found[0].data());
        hn::StoreU(crossing.u, tag, found[1].data());
        hn::StoreU(crossing.v, tag, found[2].data());
        for (std::size_t j = 0; j < Width; ++j) {
            const std::array<float, 3> wanted = scalar_crossing(triangle, rays[j]);
            const bool missed = (outside >> j & 1) != 0 || std::isnan(found[0][j]);
            ASSERT_EQ(missed, std::isnan(wanted[0])) << cases::print(rays[j]);
            if (missed) continue;
            for (std::size_t n = 0; n < 3; ++n)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(found[n][j]),
                          std::bit_cast<std::uint32_t>(wanted[n]))
                    << cases::print(rays[j]);
            ++met;
        }
    }
    EXPECT_GT(met, 5000 * Width);
}

TEST(WideEdges, rays_side_by_side_meet_a_triangle_where_each_alone_does) {
    expect_lanes_like_rays<4>();
    expect_lanes_like_rays<8>();
    expect_lanes_like_rays<simd::widest>();
}

}  // namespace
}  // namespace rayshoot
