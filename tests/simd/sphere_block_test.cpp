#include "accel/simd/sphere_block.h"
#include "tests/simd/hard_leaves.h"

/// Eight spheres and one ray, or one sphere and a ray a lane: what the shared test answers, to the
/// last bit.
namespace rayshoot {
namespace {

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

TEST(SphereBlock, answers_like_the_shared_test_with_the_same_counts) {
    cases::Random random(1);
    std::size_t hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const HardLeaf hard(Mixture::spheres, Precision::standard, random);
        const Geometry& geometry = hard.geometry;
        const std::uint32_t size = std::min(geometry.size(), 8u);
        SphereBlock block;
        for (std::uint32_t j = 0; j < size; ++j) block.set(j, geometry.sphere(j), j);
        const Ray ray = cases::hard_ray(geometry, random.below(size), random);
        const Answer wanted = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
            for (std::uint32_t j = 0; j < size; ++j)
                test_primitive<Query::closest>(geometry, j, r, hit, count);
        });
        const Answer found = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
            test(block, TestRay(r, Precision::standard), geometry.padding(), hit, count);
        });
        ASSERT_TRUE(cases::same_bits(found.hit, wanted.hit)) << cases::print(ray);
        ASSERT_EQ(found.counts, wanted.counts) << cases::print(ray);
        hits += found.hit.primitive != no_primitive;
    }
    EXPECT_GT(hits, 5000u);
}

TEST(SphereBlock, gives_back_the_spheres_it_was_given) {
    SphereBlock block;
    EXPECT_EQ(block.live(), 0u);
    for (std::uint32_t i = 0; i < 5; ++i) block.set(i, {vec3(1, 2, static_cast<float>(i)), 7}, i);
    EXPECT_EQ(block.live(), 5u);
    EXPECT_EQ(block.sphere(3).centre, vec3(1, 2, 3));
    EXPECT_EQ(block.sphere(3).radius, 7);
}

/// Both roots of one ray, none where double would have to decide.
struct Roots {
    std::array<float, 2> t{};
    std::size_t count = 0;
};
Roots scalar_roots(const Sphere& sphere, const Ray& ray) {
    Roots roots;
    intersect_sphere<float>(ray.origin - sphere.centre, sphere.radius, ray.direction,
                            [&](float t, float, float) { roots.t[roots.count++] = t; });
    return roots;
}

/// Equal, or NaN both.
bool same(float a, float b) {
    return a == b ? std::signbit(a) == std::signbit(b) : a != a && b != b;
}

template <std::size_t Width>
void expect_lanes_like_rays() {
    using namespace simd;
    using V = Floats<Width>;
    constexpr auto tag = floats<Width>;
    cases::Random random(2);
    std::size_t met = 0;
    for (int i = 0; i < 40000; ++i) {
        const HardLeaf hard(Mixture::spheres, Precision::standard, random);
        const Sphere& sphere = hard.geometry.sphere(0);
        std::array<Ray, Width> rays;
        std::array<std::array<float, Width>, 7> rows;
        for (std::size_t j = 0; j < Width; ++j) {
            rays[j] = cases::hard_ray(hard.geometry, 0, random);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                rows[axis][j] = rays[j].origin[static_cast<int>(axis)];
                rows[axis + 3][j] = rays[j].direction[static_cast<int>(axis)];
            }
            rows[6][j] = taxicab(rays[j].direction);
        }
        const auto row = [&](std::size_t n) { return hn::LoadU(tag, rows[n].data()); };
        const WideRoots<V> wide(everywhere<Width>(sphere.centre), hn::Set(tag, sphere.radius),
                                {row(0), row(1), row(2)}, {row(3), row(4), row(5)});
        const std::uint32_t trusted = bits(tag, wide.trusted(row(6)));
        const std::uint32_t found = bits(tag, wide.met()) & trusted;
        std::array<std::array<float, Width>, 2> t;
        for (std::size_t n = 0; n < 2; ++n) hn::StoreU(wide.roots()[n], tag, t[n].data());
        for (std::size_t j = 0; j < Width; ++j) {
            if ((trusted >> j & 1) == 0) continue;
            const Roots wanted = scalar_roots(sphere, rays[j]);
            ASSERT_EQ(found >> j & 1, wanted.count / 2) << cases::print(rays[j]);
            for (std::size_t n = 0; n < wanted.count; ++n)
                ASSERT_TRUE(same(t[n][j], wanted.t[n])) << cases::print(rays[j]);
            met += wanted.count / 2;
        }
    }
    EXPECT_GT(met, 5000 * Width);
}

TEST(WideRoots, rays_side_by_side_meet_a_sphere_where_each_alone_does) {
    expect_lanes_like_rays<4>();
    expect_lanes_like_rays<8>();
    expect_lanes_like_rays<simd::widest>();
}

}  // namespace
}  // namespace rayshoot
