#include "tests/contract/contract.h"
#include "tests/contract/test_catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

/// A structure that remembers: counts may depend on the session, answers may not.
namespace rayshoot::contract {
namespace {

struct Lane {
    std::unique_ptr<Session> session;
    std::vector<Hit> hits;

    explicit Lane(const Accel& accel) : session(accel.open(Mode::counting)) {}

    void trace(const Stream& stream, std::size_t first, std::size_t last) {
        hits.resize(last - first);
        for (std::size_t at = first; at < last; at += 64) {
            const std::size_t count = std::min<std::size_t>(64, last - at);
            session->closest(stream.batch(at, count), std::span(hits).subspan(at - first, count));
        }
    }
    const Counters& counters() const { return *session->counters(RayKind::secondary); }
    std::uint64_t sets() const { return counters()[Event::candidate_set]; }
};

struct Lazy : testing::Test {
    const Case tested = make_cases({.scenes = {"mixed"}}).front();
    const Stream& stream = tested.hard_rays();
    const std::unique_ptr<Accel> accel = build(test_catalogue(), "lazy_tree", tested.scene.input());

    void expect_truth(const Lane& lane, std::size_t first) const {
        const auto from = stream.truth.begin() + static_cast<std::ptrdiff_t>(first);
        EXPECT_TRUE(std::equal(lane.hits.begin(), lane.hits.end(), from, same_bits));
    }
};

TEST_F(Lazy, passes_the_contract) {
    const Report report = run_contract(test_catalogue(), "lazy_tree", {});
    EXPECT_TRUE(report.passed()) << report;
}

TEST_F(Lazy, says_that_it_remembers_and_so_does_its_composition) {
    EXPECT_TRUE(accel->remembers());
    EXPECT_TRUE(build(test_catalogue(), "picky+lazy_tree", tested.scene.input())->remembers());
    EXPECT_FALSE(build(test_catalogue(), "picky+test_tree", tested.scene.input())->remembers());
}

TEST_F(Lazy, answers_the_same_fresh_and_warm_and_builds_nothing_twice) {
    Lane lane(*accel);
    lane.trace(stream, 0, stream.size());
    expect_truth(lane, 0);
    const std::uint64_t built = lane.sets();
    EXPECT_GT(built, 0u);
    EXPECT_GT(lane.session->bytes(), 0u);
    lane.trace(stream, 0, stream.size());
    expect_truth(lane, 0);
    EXPECT_EQ(lane.sets(), built);
}

TEST_F(Lazy, counts_depend_on_the_session_but_answers_do_not) {
    Lane whole(*accel), left(*accel), right(*accel);
    const std::size_t middle = stream.size() / 2;
    whole.trace(stream, 0, stream.size());
    {
        std::jthread other([&] { left.trace(stream, 0, middle); });
        right.trace(stream, middle, stream.size());
    }
    expect_truth(whole, 0);
    expect_truth(left, 0);
    expect_truth(right, middle);
    EXPECT_GT(left.sets() + right.sets(), whole.sets());
    EXPECT_EQ(left.counters()[Event::hit] + right.counters()[Event::hit],
              whole.counters()[Event::hit]);
}

TEST_F(Lazy, counts_the_same_when_the_same_stream_is_repeated_on_a_fresh_session) {
    Lane one(*accel), other(*accel);
    one.trace(stream, 0, stream.size());
    other.trace(stream, 0, stream.size());
    EXPECT_EQ(one.counters(), other.counters());
}

}  // namespace
}  // namespace rayshoot::contract
