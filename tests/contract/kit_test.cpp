#include "tests/contract/contract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

/// The kit's own promises: its rays do hit and miss, its limits stand at the hits, its oracle keeps
/// the order that the interface demands.
namespace rayshoot::contract {
namespace {

TEST(HardScenes, have_names_of_their_own) {
    std::set<std::string_view> names;
    for (const Recipe& recipe : hard_scenes()) EXPECT_TRUE(names.insert(recipe.name).second);
    EXPECT_GE(names.size(), 50u);
}

TEST(HardScenes, come_in_every_kind_of_primitive_and_moving) {
    std::set<PrimitiveKind> still, moving;
    for (const Recipe& recipe : hard_scenes()) {
        const HardScene scene = hard_scene(recipe, Precision::standard);
        for (std::uint32_t i = 0; i < scene.geometry.size(); ++i) {
            const PrimitiveRef& ref = scene.geometry.ref(i);
            (ref.motion == no_motion ? still : moving).insert(ref.kind);
        }
    }
    EXPECT_EQ(still.size(), std::size_t{primitive_kinds});
    EXPECT_EQ(moving.size(), std::size_t{primitive_kinds});
}

TEST(HardRays, of_every_family_both_hit_and_miss) {
    std::map<std::string_view, std::array<int, 2>> seen;
    for (const Case& tested : make_cases({}))
        for (const Stream& stream : tested.streams)
            for (std::size_t i = 0; i < stream.size(); ++i)
                ++seen[stream.families[i]][stream.truth[i].primitive != no_primitive];
    for (const auto& [family, counts] : seen) {
        EXPECT_GT(counts[0], 0) << family;
        if (family != "invalid") EXPECT_GT(counts[1], 0) << family;
        else EXPECT_EQ(counts[1], 0);
    }
}

TEST(HardRays, are_the_same_every_time) {
    const Settings settings{.scenes = {"mixed", "slivers_1e4"}};
    const std::vector<Case> first = make_cases(settings), second = make_cases(settings);
    ASSERT_EQ(first.size(), second.size());
    for (std::size_t i = 0; i < first.size(); ++i)
        for (std::size_t k = 0; k < first[i].streams.size(); ++k)
            EXPECT_TRUE(std::equal(first[i].streams[k].truth.begin(),
                                   first[i].streams[k].truth.end(),
                                   second[i].streams[k].truth.begin(), same_bits));
}

TEST(Settings, leave_out_scenes_that_are_not_asked_for) {
    EXPECT_EQ(make_cases({.scenes = {"one_sphere"}}).size(), 1u);
    EXPECT_EQ(make_cases({.scenes = {"cube"}}).size(), 2u);  // both precisions
}

TEST(Streams, repeated_keep_their_truth) {
    const Case tested = make_cases({.scenes = {"cube"}}).front();
    const Stream& camera = tested.streams[1];
    const Stream longer = repeated(camera, camera.size() + 3);
    ASSERT_EQ(longer.size(), camera.size() + 3);
    EXPECT_EQ(longer.source.back().bits, camera.source[2].bits);
    EXPECT_TRUE(same_bits(longer.truth.back(), camera.truth[2]));
}

TEST(Report, fails_when_nothing_was_compared) { EXPECT_FALSE(Report{}.passed()); }

}  // namespace
}  // namespace rayshoot::contract
