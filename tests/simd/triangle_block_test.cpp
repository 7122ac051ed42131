#include "accel/simd/triangle_block.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <cstring>

/// A block of triangles answers what the shared test answers triangle by triangle, to the last bit.
namespace rayshoot {
namespace {

struct Blocked {
    TriangleBlock block;
    Geometry geometry;
};

Blocked some_triangles(cases::Random& random, std::size_t count) {
    Blocked made;
    GeometryBuilder builder;
    for (std::size_t i = 0; i < count; ++i) {
        const Triangle triangle = cases::triangle(random);
        const std::uint32_t first = builder.add_vertex(triangle.a);
        builder.add_vertex(triangle.b);
        builder.add_vertex(triangle.c);
        builder.add_triangle({first, first + 1, first + 2});
        made.block.set(i, triangle, static_cast<std::uint32_t>(i));
    }
    made.geometry = std::move(builder).build(Precision::standard);
    return made;
}

template <class Counts>
Hit one_by_one(const Geometry& geometry, const Ray& ray, Counts& count) {
    Hit hit = nothing_yet(ray);
    for (std::uint32_t i = 0; i < geometry.size(); ++i)
        test_primitive<Query::closest>(geometry, i, ray, hit, count);
    return hit;
}

TEST(TriangleBlock, answers_like_the_shared_test_with_the_same_counts) {
    cases::Random random(1);
    std::size_t hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::size_t size = 1 + random.below(4);
        const Blocked made = some_triangles(random, size);
        const std::uint32_t aim = random.below(static_cast<std::uint32_t>(size));
        const Triangle target = made.geometry.triangle(made.geometry.ref(aim).index);
        const Ray ray = cases::ray_at(cases::spot_on(target, random), 1, random);
        Counters wanted_counts, counts;
        Tally wanted_tally{&wanted_counts}, tally{&counts};
        const Hit wanted = one_by_one(made.geometry, ray, wanted_tally);
        Hit found = nothing_yet(ray);
        test(made.block, TestRay(ray, Precision::standard), made.geometry.padding(), found, tally);
        ASSERT_EQ(std::memcmp(&found, &wanted, sizeof(Hit)), 0) << cases::print(ray);
        ASSERT_EQ(counts, wanted_counts) << cases::print(ray);
        hits += found.primitive != no_primitive;
    }
    EXPECT_GT(hits, 5000u);
}

/// Of 2 000 000 rays that pass a triangle's end by a rounding there are few such.
TEST(TriangleBlock, takes_hits_back_that_the_clamp_moves_too_far) {
    cases::Random random(3);
    std::size_t taken_back = 0;
    for (int i = 0; i < 2000; ++i) {
        const Triangle triangle = cases::triangle(random);
        const Geometry geometry = cases::alone(triangle);
        const double size = cases::diagonal(geometry.bounds());
        TriangleBlock block;
        block.set(random.below(4), triangle, 0);
        for (int j = 0; j < 1000; ++j) {
            const Ray ray = cases::ray_past_an_end(triangle, size, 8, random);
            if (!cases::is_taken_back(triangle, geometry.bounds(0), ray)) continue;
            Hit hit = nothing_yet(ray);
            Counters counts;
            Tally tally{&counts};
            test(block, TestRay(ray, Precision::standard), geometry.padding(), hit, tally);
            EXPECT_EQ(hit.primitive, no_primitive) << cases::print(ray);
            EXPECT_EQ(counts[Event::object_hit], 0u);
            ++taken_back;
        }
    }
    EXPECT_GE(taken_back, 10u);
}

TEST(TriangleBlock, gives_back_the_triangles_it_was_given) {
    cases::Random random(2);
    const Blocked made = some_triangles(random, 3);
    EXPECT_EQ(made.block.live(), 3u);
    for (std::uint32_t i = 0; i < 3; ++i) {
        const Triangle wanted = made.geometry.triangle(made.geometry.ref(i).index);
        const Triangle found = made.block.triangle(i);
        EXPECT_EQ(found.a, wanted.a);
        EXPECT_EQ(found.b, wanted.b);
        EXPECT_EQ(found.c, wanted.c);
    }
}

}  // namespace
}  // namespace rayshoot
