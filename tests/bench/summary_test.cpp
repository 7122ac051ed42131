#include "bench/comparison/summary.h"

#include "bench/comparison/document.h"

#include <gtest/gtest.h>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

/// A row whose passes over 1000 rays took `seconds`.
Json row(const std::string& scene, const std::string& structure, const std::string& best,
         const std::vector<double>& seconds, double ratio_high) {
    return {{"name", "rays/" + scene + "/" + structure + "/camera"},
            {"scene", scene},
            {"structure", structure},
            {"kind", "camera"},
            {"timed_rays", 1000},
            {"seconds_samples", seconds},
            {"best_embree", best},
            {"ratio_to_best_embree", {{"median", 1}, {"low", 0.5}, {"high", ratio_high}}}};
}

/// On a ours takes half the time of Embree's best path, on b twice; each block is slower than the
/// one before, which ratios block by block do not see.
Json document() {
    Json document{{"schema", 1}, {"rows", Json::array()}};
    const std::string best = "embree:kernel=single";
    document["rows"] = {
        row("a", "ours", best, {1, 2, 3}, 2.1),     row("a", "embree", best, {4, 8, 12}, 0.5),
        row("a", best, best, {2, 4, 6}, 1),         row("b", "ours", "embree", {8, 16, 24}, 0.5),
        row("b", "embree", "embree", {1, 2, 3}, 1), row("b", best, "embree", {2, 4, 6}, 0.5)};
    return document;
}

TEST(Summary, is_the_geometric_mean_of_block_ratios_over_the_best_row_of_each_scene) {
    const Json means = summarise(document())["means"];
    ASSERT_EQ(means.size(), 3u);
    EXPECT_EQ(means[0]["structure"], "ours");
    EXPECT_EQ(means[0]["scenes"], 2);
    EXPECT_NEAR(means[0]["ratio"]["median"], 0.5, 1e-12);  // of 2 and 1/8
    EXPECT_NEAR(means[0]["ratio"]["low"], 0.5, 1e-12);
    EXPECT_NEAR(means[0]["ratio"]["high"], 0.5, 1e-12);
    EXPECT_NEAR(means[1]["ratio"]["median"], std::sqrt(0.5), 1e-12);
}

TEST(Summary, names_the_rows_of_ours_that_are_slower_beyond_their_interval) {
    EXPECT_EQ(summarise(document())["below_one"], Json({"rays/b/ours/camera"}));
    EXPECT_NE(below_embree_text(document()).find("rays/b/ours/camera"), std::string::npos);
}

TEST(Summary, is_empty_without_embree) {
    Json without = document();
    for (Json& row : without["rows"]) row["best_embree"] = nullptr;
    EXPECT_TRUE(summarise(without)["means"].empty());
    EXPECT_EQ(below_embree_text(without), "");
    EXPECT_TRUE(summary_table(without).rows.empty());
}

TEST(Summary, a_row_timed_on_a_sample_is_compared_ray_by_ray) {
    Json sampled = document();
    sampled["rows"][0]["timed_rays"] = 500;  // in the same time: half as fast
    EXPECT_NEAR(summarise(sampled)["means"][0]["ratio"]["median"], std::sqrt(0.125), 1e-12);
}

TEST(Notes, say_that_a_run_is_void_and_hide_no_row) {
    Json moved = document();
    moved["control"] = {{"blocks", 40}, {"moved", 0.07}, {"void_above", 0.05}, {"void", true}};
    EXPECT_NE(notes(moved).find("VOID"), std::string::npos);
    EXPECT_EQ(detail_table(moved).rows.size(), 6u);
    moved["control"]["void"] = false;
    EXPECT_EQ(notes(moved).find("VOID"), std::string::npos);
}

}  // namespace
}  // namespace rayshoot
