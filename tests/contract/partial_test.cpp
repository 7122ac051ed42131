#include "accel/core/session.h"
#include "tests/contract/contract.h"
#include "tests/contract/structures/wary/wary.h"
#include "tests/contract/test_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

/// Compositions of structures that answer only some rays.
namespace rayshoot::contract {
namespace {

Case soup() { return make_cases({.scenes = {"soup"}}).front(); }

struct Composed {
    std::unique_ptr<Accel> accel;
    std::unique_ptr<Session> session;
    Composed(const std::string& spec, const Case& tested)
        : accel(build(test_catalogue(), spec, tested.scene.input())),
          session(accel->open(Mode::counting)) {}

    const Counters& member(std::size_t i, RayKind kind) const {
        return *session->members()[i]->counters(kind);
    }
};

/// 100 camera rays of a case, all to be answered, with or without the promise of their cells.
Stream some_camera_rays(const Case& tested, bool promised) {
    Stream stream = tested.streams[1];
    stream.rays.resize(100);
    for (Ray& ray : stream.rays) ray.t_max = infinity;
    stream.truth.clear();
    answer_truly(tested.scene.geometry, stream);
    if (promised) stream.source.resize(100);
    else stream.source.clear();
    return stream;
}

void expect_truth(Session& session, const Stream& stream) {
    std::vector<Hit> hits(stream.size());
    std::vector<std::uint8_t> occluded(stream.size());
    EXPECT_TRUE(session.closest(stream.batch(0, stream.size()), hits).empty());
    EXPECT_TRUE(session.occluded(stream.batch(0, stream.size()), occluded).empty());
    EXPECT_TRUE(std::equal(hits.begin(), hits.end(), stream.truth.begin(), same_bits));
    for (std::size_t i = 0; i < stream.size(); ++i)
        EXPECT_EQ(occluded[i], stream.truth[i].primitive != no_primitive);
}

std::uint64_t rays_of(const Counters& counters) { return counters[Event::ray]; }
std::uint64_t declined_of(const Counters& counters) { return counters[Event::declined]; }

class EveryComposition : public testing::TestWithParam<const char*> {};

TEST_P(EveryComposition, answers_like_brute_force) {
    const Report report = run_contract(test_catalogue(), GetParam(), {});
    EXPECT_TRUE(report.passed()) << report;
}

INSTANTIATE_TEST_SUITE_P(Partial, EveryComposition,
                         testing::Values("picky+bvh", "wary+bvh", "picky+wary+bvh",
                                         "wary+picky:declines=sourceless+test_tree",
                                         "picky:serves=closest+wary+lazy_tree"),
                         [](const auto& spec) { return "spec_" + std::to_string(spec.index); });

TEST(Overlay, passes_on_what_the_first_declines) {
    const Case tested = soup();
    const Composed composed("picky:declines=odd+bvh", tested);
    const Stream stream = some_camera_rays(tested, true);
    expect_truth(*composed.session, stream);
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 100u);
    EXPECT_EQ(rays_of(composed.member(1, RayKind::camera)), 100u);
    EXPECT_EQ(declined_of(composed.member(0, RayKind::camera)), 100u);
}

TEST(Overlay, adds_its_members_up) {
    const Case tested = soup();
    const Composed composed("picky+wary+bvh", tested);
    expect_truth(*composed.session, some_camera_rays(tested, true));
    Counters sum;
    for (std::size_t i = 0; i < 3; ++i) sum += composed.member(i, RayKind::camera);
    const Counters& whole = *composed.session->counters(RayKind::camera);
    EXPECT_EQ(rays_of(whole), 200u);
    EXPECT_EQ(declined_of(whole), 0u);
    for (const Event event : {Event::ray, Event::hit, Event::object_test, Event::step})
        EXPECT_EQ(whole[event], sum[event]);
}

TEST(Overlay, asks_nobody_behind_a_member_that_declines_nothing) {
    const Case tested = soup();
    const Composed composed("picky:declines=none+bvh", tested);
    expect_truth(*composed.session, some_camera_rays(tested, true));
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 200u);
    EXPECT_EQ(composed.member(1, RayKind::camera), Counters{});
}

TEST(Overlay, hands_a_batch_on_whole_when_all_is_declined) {
    const Case tested = soup();
    const Composed composed("picky:declines=all+bvh", tested);
    expect_truth(*composed.session, some_camera_rays(tested, true));
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 0u);
    EXPECT_EQ(rays_of(composed.member(1, RayKind::camera)), 200u);
}

TEST(Overlay, does_not_ask_a_member_that_does_not_serve) {
    const Case tested = soup();
    const Composed composed("picky:declines=none,serves=shadow+bvh", tested);
    EXPECT_TRUE(composed.accel->members()[0]->serves(Query::closest, RayKind::shadow));
    EXPECT_FALSE(composed.accel->members()[0]->serves(Query::closest, RayKind::camera));
    expect_truth(*composed.session, some_camera_rays(tested, true));
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 0u);
    EXPECT_EQ(composed.member(0, RayKind::camera)[Event::object_test], 0u);
    EXPECT_EQ(rays_of(composed.member(1, RayKind::camera)), 200u);
}

TEST(Overlay, asks_each_question_of_those_that_serve_it) {
    const Case tested = soup();
    const Composed composed("picky:declines=none,serves=closest+bvh", tested);
    expect_truth(*composed.session, some_camera_rays(tested, true));
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 100u);
    EXPECT_EQ(rays_of(composed.member(1, RayKind::camera)), 100u);
}

TEST(Partial, that_needs_sources_declines_everything_without_them) {
    const Case tested = soup();
    const Composed composed("picky:declines=sourceless+bvh", tested);
    expect_truth(*composed.session, some_camera_rays(tested, false));
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 0u);
    EXPECT_EQ(declined_of(composed.member(0, RayKind::camera)), 200u);
    expect_truth(*composed.session, some_camera_rays(tested, true));
    EXPECT_EQ(rays_of(composed.member(0, RayKind::camera)), 200u);
}

/// Answers ray by ray, so that only the session can tell "no source" from cell (0, 0).
struct Sourced : Wary {
    static constexpr bool needs_source = true;
    using Wary::Wary;
};

TEST(Partial, that_says_it_needs_sources_is_not_asked_without_them) {
    const Case tested = soup();
    const BuildInput input{tested.scene.geometry};
    const Sourced structure(input, Options("sourced", {}, {}));
    StructureSession<Sourced, Tally> session(structure, input);
    std::vector<Hit> hits(100);
    const Stream without = some_camera_rays(tested, false), with = some_camera_rays(tested, true);
    EXPECT_EQ(session.closest(without.batch(0, 100), hits).size(), 100u);
    EXPECT_EQ(session.counters(RayKind::camera)->operator[](Event::object_test), 0u);
    session.closest(with.batch(0, 100), hits);
    EXPECT_GT(session.counters(RayKind::camera)->operator[](Event::object_test), 0u);
}

TEST(Partial, reports_what_it_declines_in_ascending_order) {
    const Case tested = soup();
    for (const char* spec : {"picky+bvh", "wary+bvh", "picky:declines=all+bvh"}) {
        const Composed composed(spec, tested);
        Session& alone = *composed.session->members()[0];
        const Stream& stream = tested.hard_rays();  // with invalid rays, which nobody declines
        const auto size = static_cast<std::uint32_t>(stream.size());
        std::vector<Hit> hits(size);
        const auto declined = alone.closest(stream.batch(0, size), hits);
        ASSERT_FALSE(declined.empty());
        EXPECT_TRUE(std::is_sorted(declined.begin(), declined.end()));
        EXPECT_EQ(std::adjacent_find(declined.begin(), declined.end()), declined.end());
        EXPECT_LT(declined.back(), size);
        for (std::uint32_t i = 0; i < size; ++i) {
            if (std::binary_search(declined.begin(), declined.end(), i)) continue;
            EXPECT_TRUE(same_bits(hits[i], stream.truth[i])) << spec << ", ray " << i;
        }
    }
}

TEST(Specs, that_cannot_answer_every_ray_are_refused) {
    const Case tested = soup();
    for (const char* spec : {"picky", "picky+wary", "bvh+picky", "bvh+bvh", "picky+bvh+wary",
                             "picky+picky+bvh", "picky++bvh", "+bvh", ""})
        EXPECT_THROW(build(test_catalogue(), spec, tested.scene.input()), std::invalid_argument)
            << spec;
}

TEST(Specs, refused_because_partial_name_a_composition) {
    const Case tested = soup();
    try {
        build(test_catalogue(), "picky", tested.scene.input());
        FAIL() << "a lone partial structure was built";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("picky+"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace rayshoot::contract
