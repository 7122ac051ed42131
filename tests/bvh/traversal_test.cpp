#include <gtest/gtest.h>

#include "accel/bvh8/flight.h"
#include "accel/bvh8/group_walk.h"
#include "accel/bvh8/halts.h"

#include <algorithm>
#include <bit>
#include <random>

/// What lies open on the way through a wide tree, against the same by hand.
namespace rayshoot::bvh_test {
namespace {

constexpr std::size_t width = 8;
using Row = std::array<float, width>;

simd::Floats<width> loaded(const Row& row) {
    return simd::hn::LoadU(simd::floats<width>, row.data());
}

Places<width> some(std::uint32_t places) {
    using namespace simd;
    alignas(32) std::array<std::uint32_t, width> lanes{};
    for_each(places, [&](std::size_t i) { lanes[i] = ~0u; });
    return hn::RebindMask(floats<width>,
                          hn::Ne(hn::Load(words<width>, lanes.data()), hn::Zero(words<width>)));
}

/// test(places, entries) for every set of places but the empty one, each with entries of its own.
template <class Test>
void for_all_places(Test&& test) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> entry(0, 10);
    for (std::uint32_t places = 1; places < 256; ++places) {
        Row entries;
        for (float& e : entries) e = entry(random);
        test(places, entries);
    }
}

/// Of the least entry; of those that differ only in the last three bits any.
void expect_nearest(std::uint32_t places, const Row& entries) {
    const std::uint32_t nearest = nearest_of(some(places), loaded(entries));
    ASSERT_LT(nearest, width);
    ASSERT_NE(places >> nearest & 1, 0u);
    const auto key = [&](std::size_t i) { return std::bit_cast<std::int32_t>(entries[i]) & ~7; };
    simd::for_each(places, [&](std::size_t i) { EXPECT_LE(key(nearest), key(i)); });
}

TEST(NearestOf, is_the_place_of_the_least_of_those_that_are_met) {
    for_all_places(expect_nearest);
    expect_nearest(255, {infinity, 3, 2, 1, 0, infinity, 1e-40f, 1e30f});
}

TEST(NearestOf, nothing_is_the_last_place) {
    EXPECT_EQ(nearest_of(some(0), loaded(Row{})), width - 1);
}

/// Pushes children 0, 1, ... that begin at `entries`.
void push_all(Stack& stack, std::span<const float> entries) {
    for (std::uint32_t i = 0; i < entries.size(); ++i) stack.push(WideChild::node(i), entries[i]);
}

/// The numbers of what is left, from the top down.
std::vector<std::uint32_t> left(Stack& stack) {
    std::vector<std::uint32_t> numbers;
    for (; !stack.top().is_none(); stack.drop()) numbers.push_back(stack.top().number());
    return numbers;
}

TEST(StackOfChildren, loses_what_begins_behind_the_hit_and_keeps_the_order) {
    Stack stack;
    push_all(stack, std::vector<float>{5, 1, 4, 2, 3});
    EXPECT_EQ(stack.cull(3).number(), 4u);
    EXPECT_EQ(left(stack), (std::vector<std::uint32_t>{4, 3, 1}));
}

TEST(StackOfChildren, keeps_what_begins_exactly_at_the_hit) {
    Stack stack;
    push_all(stack, std::vector<float>{2, std::nextafter(2.0f, 3.0f)});
    EXPECT_EQ(stack.cull(2).number(), 0u);
    EXPECT_EQ(left(stack), std::vector<std::uint32_t>{0});
}

TEST(StackOfChildren, with_nothing_in_reach_has_none_at_its_bottom) {
    Stack stack;
    EXPECT_TRUE(stack.top().is_none());
    EXPECT_TRUE(stack.cull(1).is_none());
    push_all(stack, std::vector<float>{2, 3});
    EXPECT_TRUE(stack.cull(1).is_none());
    EXPECT_TRUE(stack.top().is_none());
}

TEST(StackOfChildren, culls_the_last_eight_alone) {
    Stack stack;
    push_all(stack, std::vector<float>(10, 7));
    EXPECT_EQ(stack.cull(1).number(), 1u);
    EXPECT_EQ(left(stack), (std::vector<std::uint32_t>{1, 0}));
}

TEST(StackOfChildren, takes_whole_vectors_of_which_some_lanes_count) {
    using namespace simd;
    Stack stack;
    stack.push(2, hn::Iota(words<width>, 20), hn::Set(floats<width>, 1.0f));
    EXPECT_EQ(left(stack), (std::vector<std::uint32_t>{21, 20}));
}

TEST(HaltsOfABeam, have_the_nearest_child_on_top_and_all_others_below) {
    for_all_places([](std::uint32_t places, const Row& entries) {
        Halts<width> halts;
        halts.clear();
        halts.push(7, some(places), loaded(entries));
        ASSERT_EQ(halts.size(), static_cast<std::size_t>(std::popcount(places)));
        float least = infinity;
        simd::for_each(places, [&](std::size_t i) { least = std::min(least, entries[i]); });
        EXPECT_NEAR(halts.top().entry, least, 1e-5f);
        std::uint32_t met = 0;
        for (; !halts.empty(); halts.drop()) {
            EXPECT_EQ(halts.top().node, 7u);
            EXPECT_EQ(halts.top().entry, entries[halts.top().place]);
            met |= 1u << halts.top().place;
        }
        EXPECT_EQ(met, places);
    });
}

TEST(WalkOfAGroup, admits_what_any_ray_enters) {
    GroupWalk walk;
    walk.clear();
    walk.admit(WideChild::node(1), 0b101, 0.5f);
    walk.admit(WideChild::node(2), 0, 0.25f);
    walk.admit(WideChild::node(3), Packet::everyone, 0.75f);
    const GroupHalt last = walk.pop(), first = walk.pop();
    EXPECT_TRUE(walk.empty());
    EXPECT_EQ(last.child.number(), 3u);
    EXPECT_EQ(last.rays, Packet::everyone);
    EXPECT_EQ(last.entry, 0.75f);
    EXPECT_EQ(first.child.number(), 1u);
    EXPECT_EQ(first.rays, 0b101u);
}

TEST(Company, pays_until_few_rays_on_average_share_many_nodes) {
    Company company;
    for (int node = 0; node < 63; ++node) company.note(0b111);
    EXPECT_TRUE(company.pays<Query::occluded>());
    company.note(0b111);
    EXPECT_FALSE(company.pays<Query::occluded>());
    for (int node = 0; node < 6; ++node) company.note(Packet::everyone);
    EXPECT_TRUE(company.pays<Query::occluded>());
}

}  // namespace
}  // namespace rayshoot::bvh_test
