#include "bench/gate/gate.h"

#include "bench/streams/random_rays.h"
#include "bench/streams/record.h"
#include "data/scenes.h"
#include "tests/bench/faulty.h"

#include <gtest/gtest.h>

namespace rayshoot {
namespace {

class GateTest : public testing::Test {
protected:
    Verdict judge(std::string_view spec) const {
        const auto accel = build(catalogue_, spec, input_);
        return gate_.judge(*accel, agreement(catalogue_, spec));
    }

    Catalogue catalogue_ = faulty_catalogue();
    Scene scene_ = load_scene("soup:count=300");
    BuildInput input_{scene_.geometry, std::nullopt, scene_.lights, nullptr};
    RayStream stream_ = hostile_rays(scene_.geometry, 6000, 1);
    Gate gate_{catalogue_, input_, stream_, {}};
};

TEST_F(GateTest, lets_sound_structures_through) {
    for (const char* spec : {"sound", "bvh", "bvh:leaf=1", "tolerant"}) {
        const Verdict verdict = judge(spec);
        EXPECT_TRUE(verdict.passed) << spec << ": " << verdict.reason;
        EXPECT_EQ(verdict.compared, stream_.size());
    }
    EXPECT_EQ(judge("sound").digest, judge("bvh").digest);
}

TEST_F(GateTest, catches_one_ulp_of_t_and_says_where) {
    const Verdict verdict = judge("wrong");
    EXPECT_FALSE(verdict.passed);
    EXPECT_NE(verdict.reason.find("0x1."), std::string::npos) << verdict.reason;
}

TEST_F(GateTest, catches_wrong_primitives_and_missed_hits) {
    EXPECT_FALSE(judge("mistaken").passed);
    EXPECT_FALSE(judge("blind").passed);
}

TEST_F(GateTest, tolerance_does_not_cover_missed_hits) { EXPECT_FALSE(judge("off").passed); }

TEST_F(GateTest, brute_force_answers_all_rays_where_that_is_affordable) {
    EXPECT_EQ(gate_.oracle_rays(), stream_.size());
    GateSettings dear;
    dear.affordable_tests = 1;
    EXPECT_EQ(Gate(catalogue_, input_, stream_, dear).oracle_rays(), 4096u);
    dear.most_tests = 1000 * input_.geometry.size();
    EXPECT_EQ(Gate(catalogue_, input_, stream_, dear).oracle_rays(), 1000u);
    dear.most_tests = 1;
    EXPECT_EQ(Gate(catalogue_, input_, stream_, dear).oracle_rays(), 256u);
}

TEST_F(GateTest, a_sample_is_judged_like_the_whole) {
    const auto chosen = spread_sample(stream_.size(), 3000, 2);
    const auto oracle = build(catalogue_, oracle_spec, input_);
    EXPECT_TRUE(gate_.judge_sample(*oracle, Agreement::exact, chosen).passed);
    const auto blind = build(catalogue_, "blind", input_);
    EXPECT_FALSE(gate_.judge_sample(*blind, Agreement::exact, chosen).passed);
}

TEST_F(GateTest, a_wrong_reference_lets_nobody_through) {
    Catalogue upside_down;
    for (StructureEntry entry : catalogue_) {
        if (entry.name == "bvh") continue;
        if (entry.name == "blind") entry.name = "bvh";
        upside_down.push_back(entry);
    }
    const Gate gate(upside_down, input_, stream_, {});
    const auto accel = build(upside_down, "sound", input_);
    EXPECT_FALSE(gate.judge(*accel, Agreement::exact).passed);
}

TEST_F(GateTest, untrue_sources_are_caught_before_anything_is_traced) {
    RayStream lying = stream_;
    lying.batch_kind = RayKind::shadow;
    lying.sources.assign(lying.size(), Source::light(1000));
    const Gate gate(catalogue_, input_, lying, {});
    const auto accel = build(catalogue_, "bvh", input_);
    EXPECT_FALSE(gate.judge(*accel, Agreement::exact).passed);
}

TEST_F(GateTest, threads_change_neither_answers_nor_counts) {
    const auto accel = build(catalogue_, "bvh", input_);
    StreamTracer one(*accel, stream_, {1, 256});
    StreamTracer two(*accel, stream_, {2, 256});
    one.trace_fresh();
    two.trace_fresh();
    EXPECT_EQ(one.answers().digest(), two.answers().digest());
    EXPECT_EQ(count_stream(*accel, stream_, 256).total, count_stream(*accel, stream_, 1024).total);
}

TEST_F(GateTest, counts_are_those_of_the_definition_for_brute_force) {
    const auto oracle = build(catalogue_, oracle_spec, input_);
    const StreamCounts counts = count_stream(*oracle, stream_, 1024);
    ASSERT_TRUE(counts.available);
    EXPECT_EQ(counts.total[Event::ray], stream_.size());
    EXPECT_EQ(counts.total[Event::object_test], 300u * stream_.size());
    EXPECT_EQ(counts.total[Event::bounding_volume_test], 0u);
}

TEST_F(GateTest, settings_out_of_range_are_refused) {
    const auto accel = build(catalogue_, "bvh", input_);
    EXPECT_THROW(StreamTracer(*accel, stream_, {0, 256}), std::invalid_argument);
    EXPECT_THROW(StreamTracer(*accel, stream_, {1, 0}), std::invalid_argument);
    EXPECT_THROW(StreamTracer(*accel, stream_, {1, max_batch + 1}), std::invalid_argument);
}

TEST(Streams, of_equal_scenes_are_equal) {
    const Catalogue catalogue = built_in_catalogue();
    const Scene scene = load_scene("spd/tetra:size=3");
    const ImageFormat format{32, 32, 1, Raster::centres, 0};
    const auto a = record_streams(catalogue, scene, usual_stream_kinds, format);
    const auto b = record_streams(catalogue, scene, usual_stream_kinds, format);
    ASSERT_EQ(a.size(), 4u);
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_EQ(a[i].size(), b[i].size());
        EXPECT_GT(a[i].size(), 0u);
        const auto bytes = std::as_bytes(std::span(a[i].rays));
        EXPECT_TRUE(std::ranges::equal(bytes, std::as_bytes(std::span(b[i].rays))));
    }
}

}  // namespace
}  // namespace rayshoot
