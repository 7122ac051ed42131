#include "accel/core/promise.h"
#include "tests/contract/contract.h"
#include "tests/contract/test_catalogue.h"

#include <gtest/gtest.h>

/// Sources are promises: kept ones are believed, broken ones stop a debug build.
namespace rayshoot::contract {
namespace {

const Case& mixed() {
    static const Case tested = make_cases({.scenes = {"mixed"}}).front();
    return tested;
}

const Stream& camera_stream() { return mixed().streams[1]; }
const Stream& shadow_stream() { return mixed().streams[2]; }

/// The stream with the source of one ray changed to a wrong one.
Stream broken(const Stream& stream, std::size_t i, Source wrong) {
    Stream spoilt = stream;
    spoilt.source[i] = wrong;
    return spoilt;
}

std::string complaint(const Stream& stream) {
    return broken_promise(mixed().scene.input(), stream.batch(0, 500));
}

TEST(Promises, of_the_kits_own_rays_are_kept) {
    for (const Case& tested : make_cases({}))
        for (const Stream& stream : tested.streams)
            EXPECT_EQ(broken_promise(tested.scene.input(), stream.batch(0, stream.size())), "")
                << tested.name() << ", " << stream.name;
}

TEST(Promises, that_are_broken_are_named) {
    EXPECT_NE(complaint(broken(camera_stream(), 300, Source::cell(-2, 20))), "");
    EXPECT_NE(complaint(broken(shadow_stream(), 120, Source::light(1))), "");
    EXPECT_NE(complaint(broken(shadow_stream(), 120, Source::light(2))), "");
    EXPECT_NE(complaint(broken(shadow_stream(), 120, Source::light(99))), "");
}

TEST(Promises, of_rays_that_are_not_answered_do_not_matter) {
    Stream stream = broken(camera_stream(), 300, Source::cell(-2, 20));
    stream.rays[300].t_max = -infinity;
    EXPECT_EQ(complaint(stream), "");
}

#ifdef NDEBUG
TEST(Promises, that_are_broken_pass_unseen_where_nothing_is_asserted) {
    const auto accel = build(test_catalogue(), "picky+bvh", mixed().scene.input());
    std::vector<Hit> hits(500);
    const Stream stream = broken(camera_stream(), 300, Source::cell(-2, 20));
    EXPECT_TRUE(accel->open(Mode::timing)->closest(stream.batch(0, 500), hits).empty());
}
#else
TEST(PromisesDeathTest, that_are_broken_stop_a_debug_build) {
    const auto accel = build(test_catalogue(), "picky+bvh", mixed().scene.input());
    const auto session = accel->open(Mode::timing);
    std::vector<Hit> hits(500);
    const Stream camera = broken(camera_stream(), 300, Source::cell(-2, 20));
    EXPECT_DEATH(session->closest(camera.batch(0, 500), hits), "broken promise.*cell");
    const Stream shadow = broken(shadow_stream(), 120, Source::light(99));
    EXPECT_DEATH(session->closest(shadow.batch(0, 500), hits), "broken promise.*light 99");
}
#endif

}  // namespace
}  // namespace rayshoot::contract
