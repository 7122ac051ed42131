#include "accel/simd/leaf_packer.h"
#include "tests/simd/hard_leaves.h"

/// Leaves of blocks answer and count what the scalar leaves do, to the last bit.
namespace rayshoot {
namespace {

using cases::Answer;
using cases::HardLeaf;
using cases::Mixture;

struct Both {
    Leaves scalar;
    PackedLeaves packed;
    LeafRange range;
    PackedLeaf leaf;

    explicit Both(const HardLeaf& hard) : leaf(PackedLeaf::mixed(0)) {
        range = {0, static_cast<std::uint32_t>(hard.members.size())};
        scalar = Leaves(hard.geometry, hard.members, std::span(&range, 1));
        LeafPacker packer(hard.geometry);
        leaf = packer.add(hard.members);
        packed = std::move(packer).build();
    }
    template <Query Q>
    Answer wanted(const Ray& ray) const {
        return cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
            scalar.test<Q>(range, scalar.prepared(r), hit, count);
        });
    }
    template <Query Q>
    Answer found(const Ray& ray) const {
        return cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
            packed.test<Q>(leaf, packed.prepared(r), hit, count);
        });
    }
};

struct Kind {
    Mixture mixture;
    Precision precision;
    const char* name;

    friend void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }
};

class PackedLeavesOf : public testing::TestWithParam<Kind> {};

/// Over all kinds more than ten million pairs of a ray and a primitive.
TEST_P(PackedLeavesOf, hard_cases_answer_and_count_like_the_scalar_leaves) {
    cases::Random random(1);
    std::uint64_t tests = 0, hits = 0, limited_hits = 0;
    for (int i = 0; i < 6000; ++i) {
        const HardLeaf hard(GetParam().mixture, GetParam().precision, random);
        const Both both(hard);
        for (int j = 0; j < 40; ++j) {
            const auto aim = random.below(static_cast<std::uint32_t>(hard.members.size()));
            Ray ray = cases::hard_ray(hard.geometry, aim, random);
            Answer wanted = both.wanted<Query::closest>(ray);
            if (wanted.hit.primitive != no_primitive && random.below(2) == 0) {
                ray = cases::ending_near(ray, wanted.hit.t, random);
                wanted = both.wanted<Query::closest>(ray);
                limited_hits += wanted.hit.primitive != no_primitive;
            }
            const Answer found = both.found<Query::closest>(ray);
            ASSERT_TRUE(cases::same_bits(found.hit, wanted.hit)) << cases::print(ray);
            ASSERT_EQ(found.counts, wanted.counts) << cases::print(ray);
            ASSERT_EQ(both.found<Query::occluded>(ray).hit.primitive != no_primitive,
                      wanted.hit.primitive != no_primitive)
                << cases::print(ray);
            tests += wanted.counts[Event::object_test];
            hits += wanted.counts[Event::object_hit];
        }
    }
    EXPECT_GT(tests, 2'000'000u);
    EXPECT_GT(hits, 200'000u);
    EXPECT_GT(limited_hits, 10'000u);
}

TEST_P(PackedLeavesOf, the_occluded_query_may_stop_once_something_is_hit) {
    cases::Random random(2);
    std::uint64_t saved = 0;
    for (int i = 0; i < 300; ++i) {
        const HardLeaf hard(GetParam().mixture, GetParam().precision, random);
        const Both both(hard);
        for (int j = 0; j < 10; ++j) {
            const Ray ray = cases::hard_ray(hard.geometry, 0, random);
            const Answer found = both.found<Query::occluded>(ray);
            const std::uint64_t tests = found.counts[Event::object_test];
            ASSERT_LE(tests, hard.members.size());
            if (found.hit.primitive == no_primitive) {
                ASSERT_EQ(tests, hard.members.size());
            }
            saved += hard.members.size() - tests;
        }
    }
    EXPECT_GT(saved, 1000u);
}

INSTANTIATE_TEST_SUITE_P(
    Every, PackedLeavesOf,
    testing::Values(Kind{Mixture::triangles, Precision::standard, "triangles"},
                    Kind{Mixture::triangles, Precision::watertight, "watertight_triangles"},
                    Kind{Mixture::spheres, Precision::standard, "spheres"},
                    Kind{Mixture::spheres, Precision::watertight, "spheres_padded"},
                    Kind{Mixture::both, Precision::standard, "both"},
                    Kind{Mixture::anything, Precision::standard, "anything"},
                    Kind{Mixture::anything, Precision::watertight, "anything_watertight"}),
    [](const auto& instance) { return std::string(instance.param.name); });

Geometry spheres_and_triangles(std::uint32_t spheres, std::uint32_t triangles) {
    cases::Random random(3);
    GeometryBuilder builder;
    for (std::uint32_t i = 0; i < spheres; ++i) builder.add_sphere(cases::sphere(random));
    for (std::uint32_t i = 0; i < triangles; ++i) {
        const Triangle triangle = cases::triangle(random);
        builder.add_triangle(triangle.a, triangle.b, triangle.c);
    }
    return std::move(builder).build();
}

std::vector<std::uint32_t> numbers(std::uint32_t first, std::uint32_t count) {
    std::vector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < count; ++i) all.push_back(first + i);
    return all;
}

TEST(PackedLeaf, of_one_kind_is_its_blocks) {
    const Geometry geometry = spheres_and_triangles(100, 100);
    LeafPacker packer(geometry);
    const PackedLeaf triangles = packer.add(numbers(100, 9));
    const PackedLeaf spheres = packer.add(numbers(0, 9));
    const PackedLeaf more_triangles = packer.add(numbers(109, 32));
    const PackedLeaf both = packer.add(numbers(99, 2)), none = packer.add({});
    const PackedLeaf many = packer.add(numbers(100, 33));
    const PackedLeaves leaves = std::move(packer).build();
    EXPECT_TRUE(triangles.only_triangles());
    EXPECT_EQ(triangles.first_block(), 0u);
    EXPECT_EQ(triangles.block_count(), 3u);
    EXPECT_FALSE(spheres.only_triangles());
    EXPECT_FALSE(spheres.is_mixed());
    EXPECT_EQ(spheres.first_block(), 3u);
    EXPECT_EQ(spheres.block_count(), 2u);
    EXPECT_EQ(more_triangles.first_block(), 5u);
    EXPECT_EQ(more_triangles.block_count(), PackedLeaf::most_blocks);
    for (const PackedLeaf leaf : {both, none, many}) EXPECT_TRUE(leaf.is_mixed());
    for (const PackedLeaf leaf : {triangles, spheres, more_triangles, both, none, many}) {
        EXPECT_EQ(PackedLeaf::from(leaf.bits()).bits(), leaf.bits());
        EXPECT_EQ(leaf.bits() >> 31, 0u);
    }
    const auto address = [&](PackedLeaf leaf) -> const void* {
        return leaves.first() + PackedLeaves::offset(leaf);
    };
    EXPECT_EQ(address(triangles), &leaves.triangles(0));
    EXPECT_EQ(address(spheres), &leaves.spheres(3));
    EXPECT_EQ(address(more_triangles), &leaves.triangles(5));
    EXPECT_EQ(more_triangles.after_first().first_block(), 6u);
    EXPECT_EQ(more_triangles.after_first().block_count(), PackedLeaf::most_blocks - 1);
    EXPECT_EQ(leaves.triangles(2).live(), 1u);
    EXPECT_EQ(leaves.spheres(4).live(), 1u);
    EXPECT_EQ(leaves.bytes(), (5 + 8 + 2 + 9) * sizeof(LeafBlock) + 3 * 20);
}

TEST(PackedLeaf, the_last_one_of_each_kind_still_fits) {
    constexpr std::uint32_t most = PackedLeaf::most_blocks;
    const auto last_triangles =
        PackedLeaf::triangles(PackedLeaf::most_triangle_blocks - most, most);
    EXPECT_TRUE(last_triangles.only_triangles());
    EXPECT_EQ(last_triangles.first_block(), PackedLeaf::most_triangle_blocks - most);
    EXPECT_EQ(last_triangles.block_count(), most);
    const auto last_spheres = PackedLeaf::spheres(PackedLeaf::most_sphere_blocks - most, most);
    EXPECT_FALSE(last_spheres.only_triangles() || last_spheres.is_mixed());
    EXPECT_EQ(last_spheres.first_block(), PackedLeaf::most_sphere_blocks - most);
    const auto last_mixed = PackedLeaf::mixed(PackedLeaf::most_mixed - 1);
    EXPECT_TRUE(last_mixed.is_mixed());
    EXPECT_EQ(last_mixed.number(), PackedLeaf::most_mixed - 1);
}

TEST(PackedLeaves, of_several_kinds_stop_after_the_kind_that_occludes) {
    GeometryBuilder builder;
    builder.add_frustum({vec3(0, 0, -1), 2, vec3(0, 0, 1), 2});
    builder.add_sphere({vec3(0), 2});
    builder.add_triangle(vec3(0, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1));
    const Geometry geometry = std::move(builder).build();
    LeafPacker packer(geometry);
    const PackedLeaf leaf = packer.add(numbers(0, 3));
    const PackedLeaves leaves = std::move(packer).build();
    const auto tests = [&](const vec3& origin) {
        const Answer answer =
            cases::ask({origin, 0, vec3(1, 0, 0)}, [&](const Ray& r, Hit& hit, auto& count) {
                leaves.test<Query::occluded>(leaf, leaves.prepared(r), hit, count);
            });
        EXPECT_NE(answer.hit.primitive, no_primitive);
        return answer.counts[Event::object_test];
    };
    EXPECT_EQ(tests(vec3(-9, 0.25f, 0.25f)), 1u);
    EXPECT_EQ(tests(vec3(-9, -0.25f, 0.25f)), 2u);
    EXPECT_EQ(tests(vec3(-9, 1.99f, 0.9f)), 3u);
}

TEST(PackedLeaves, of_nothing_answer_nothing) {
    const Geometry geometry = GeometryBuilder().build();
    LeafPacker packer(geometry);
    const PackedLeaf leaf = packer.add({});
    const PackedLeaves leaves = std::move(packer).build();
    const Ray ray;
    const Answer answer = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
        leaves.test<Query::closest>(leaf, leaves.prepared(r), hit, count);
    });
    EXPECT_EQ(answer.hit.primitive, no_primitive);
    EXPECT_EQ(answer.counts, Counters{});
}

/// The leaves of a whole scene, repeated members and all, ask for the right blocks.
TEST(PackedLeaves, each_has_its_own_members) {
    const Geometry geometry = spheres_and_triangles(60, 60);
    cases::Random random(4);
    std::vector<std::uint32_t> order;
    std::vector<LeafRange> ranges;
    LeafPacker packer(geometry);
    std::vector<PackedLeaf> packed;
    for (int i = 0; i < 50; ++i) {
        std::vector<std::uint32_t> members;
        for (std::uint32_t j = random.below(7); j > 0; --j)
            members.push_back(i % 3 == 0 ? 60 + random.below(60) : random.below(120));
        ranges.push_back(
            {static_cast<std::uint32_t>(order.size()), static_cast<std::uint32_t>(members.size())});
        order.insert(order.end(), members.begin(), members.end());
        packed.push_back(packer.add(members));
    }
    const Leaves scalar(geometry, order, ranges);
    const PackedLeaves leaves = std::move(packer).build();
    for (std::size_t i = 0; i < ranges.size(); ++i)
        for (std::uint32_t j = 0; j < geometry.size(); ++j) {
            const Ray ray = cases::hard_ray(geometry, j, random);
            const Answer wanted = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
                scalar.test<Query::closest>(ranges[i], scalar.prepared(r), hit, count);
            });
            const Answer found = cases::ask(ray, [&](const Ray& r, Hit& hit, auto& count) {
                leaves.test<Query::closest>(packed[i], leaves.prepared(r), hit, count);
            });
            ASSERT_TRUE(cases::same_bits(found.hit, wanted.hit)) << cases::print(ray);
            ASSERT_EQ(found.counts, wanted.counts);
        }
}

}  // namespace
}  // namespace rayshoot
