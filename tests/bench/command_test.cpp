#include "tests/bench/command.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

void expect_keys(const Json& object, const std::vector<std::string>& keys) {
    ASSERT_TRUE(object.is_object());
    for (const std::string& key : keys) EXPECT_TRUE(object.contains(key)) << key;
}

const std::vector<std::string> counter_keys{
    "rays",  "hits",        "object_tests",  "object_hits", "bounding_volume_tests", "steps",
    "cells", "empty_cells", "mailbox_skips", "cache_hits",  "candidate_sets",        "declined"};

TEST(List, is_one_document_with_every_structure_and_scene) {
    const Call listed = call({"list", "--json"});
    ASSERT_EQ(listed.code, 0) << listed.err;
    const Json document = listed.json();
    EXPECT_EQ(document["schema"], 1);
    std::set<std::string> names;
    for (const Json& structure : document["structures"]) {
        expect_keys(structure, {"name", "agreement", "serves", "options", "configurations"});
        names.insert(structure["name"]);
    }
    EXPECT_TRUE(names.contains("brute_force") && names.contains("bvh"));
    for (const Json& scene : document["scenes"]) expect_keys(scene, {"name", "available"});
    EXPECT_GT(document["scenes"].size(), 10u);
}

TEST(List, text_names_structures_and_scenes) {
    const Call listed = call({"list"});
    EXPECT_EQ(listed.code, 0);
    EXPECT_NE(listed.out.find("brute_force"), std::string::npos);
    EXPECT_NE(listed.out.find("spd/balls"), std::string::npos);
}

TEST(Count, has_the_documented_keys) {
    const Call counted = call({"count", "--scene", "spd/tetra:size=2", "--structure", "bvh",
                               "--size", "16x16", "--json"});
    ASSERT_EQ(counted.code, 0) << counted.err;
    const Json document = counted.json();
    expect_keys(document,
                {"schema", "scene", "structure", "primitives", "rays", "totally_reflected",
                 "footprint", "members", "build_seconds", "seconds"});
    for (const char* kind : {"camera", "shadow", "secondary"})
        expect_keys(document["rays"][kind], counter_keys);
    expect_keys(document["footprint"],
                {"interior", "leaves", "empty_leaves", "references", "depth", "bytes", "remark"});
    EXPECT_EQ(document["rays"]["camera"]["rays"], 256);
    EXPECT_GT(document["rays"]["camera"]["hits"], 0);
    EXPECT_EQ(document["primitives"], 16);
}

TEST(Count, of_brute_force_is_rays_times_primitives) {
    const Json document = call({"count", "--scene", "spd/tetra:size=2", "--structure",
                                "brute_force", "--size", "16x16", "--json"})
                              .json();
    EXPECT_EQ(document["rays"]["camera"]["object_tests"], 256 * 16);
}

TEST(Count, default_size_is_that_of_the_published_tables) {
    const Json document =
        call({"count", "--scene", "spd/jacks", "--structure", "bvh", "--json"}).json();
    EXPECT_EQ(document["rays"]["camera"]["rays"], 513 * 513);
    EXPECT_EQ(document["rules"], "spd-readme");
}

TEST(Count, tells_of_refractions_that_published_tables_count_and_nobody_traces) {
    const Json document = call({"count", "--scene", "spd/gears:size=1", "--structure", "bvh",
                                "--size", "64x64", "--json"})
                              .json();
    EXPECT_GT(document["totally_reflected"], 0);
    EXPECT_LT(document["totally_reflected"], document["rays"]["secondary"]["rays"]);
}

TEST(Check, finds_no_difference_in_the_bvh) {
    const Call checked = call({"check", "--scene", "soup:count=100", "--structure", "bvh", "--rays",
                               "1200", "--seed", "7", "--json"});
    EXPECT_EQ(checked.code, 0) << checked.err;
    const Json document = checked.json();
    expect_keys(document, {"rays", "declined", "differences", "first_difference"});
    EXPECT_EQ(document["rays"], 1200);
    EXPECT_EQ(document["differences"], 0);
    EXPECT_TRUE(document["first_difference"].is_null());
}

TEST(Check, of_a_wrong_structure_exits_with_1_and_shows_the_ray) {
    const Call checked = call(
        {"check", "--scene", "soup:count=100", "--structure", "blind", "--rays", "6000", "--json"});
    EXPECT_EQ(checked.code, 1);
    const Json document = checked.json();
    EXPECT_GT(document["differences"], 0);
    expect_keys(document["first_difference"], {"ray", "question", "expected", "found", "asked"});
}

TEST(Render, prints_the_hash_of_the_floats) {
    const auto folder = fresh_folder("render");
    const std::vector<std::string> arguments{
        "render", "--scene", "spd/tetra:size=2",          "--structure", "bvh", "--size",
        "16x16",  "--out",   (folder / "a.png").string(), "--threads",   "1",   "--json"};
    const Call first = call(arguments);
    ASSERT_EQ(first.code, 0) << first.err;
    expect_keys(first.json(), {"schema", "sha256", "seconds"});
    EXPECT_EQ(first.json()["sha256"].get<std::string>().size(), 64u);
    EXPECT_TRUE(std::filesystem::exists(folder / "a.png"));
    std::vector<std::string> two_threads = arguments;
    two_threads[10] = "2";
    EXPECT_EQ(call(two_threads).json()["sha256"], first.json()["sha256"]);
}

TEST(Rays, a_recorded_file_counts_like_the_image_it_came_from) {
    const std::string file = (fresh_folder("rays") / "camera.rays").string();
    const Call recorded = call({"rays", "--scene", "spd/tetra:size=2", "--kind", "camera", "--size",
                                "16x16", "--spp", "2", "--out", file, "--json"});
    ASSERT_EQ(recorded.code, 0) << recorded.err;
    EXPECT_EQ(recorded.json()["rays"], 512);
    const Call counted = call({"count", "--scene", "spd/tetra:size=2", "--structure", "brute_force",
                               "--rays-file", file, "--json"});
    ASSERT_EQ(counted.code, 0) << counted.err;
    EXPECT_EQ(counted.json()["rays"]["camera"]["object_tests"], 512 * 16);
    const Call checked = call({"check", "--scene", "spd/tetra:size=2", "--structure", "bvh",
                               "--rays-file", file, "--json"});
    ASSERT_EQ(checked.code, 0) << checked.err;
    EXPECT_EQ(checked.json()["rays"], 512);
}

Call small_bench(std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "bench", "--scene", "spd/tetra:size=2", "--size", "24x24", "--repetitions", "2", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return call(arguments);
}

TEST(Bench, has_the_documented_keys) {
    const Call measured = small_bench(
        {"--structure", "brute_force", "bvh", "--rays", "camera,shadow,diffuse,random"});
    ASSERT_EQ(measured.code, 0) << measured.err;
    const Json document = measured.json();
    EXPECT_EQ(document["schema"], 1);
    ASSERT_EQ(document["rows"].size(), 8u);
    for (const Json& row : document["rows"]) {
        expect_keys(row, {"scene", "structure", "kind", "threads", "build_seconds", "bytes",
                          "mrays_per_second", "ratio_to_embree"});
        expect_keys(row["mrays_per_second"], {"median", "low", "high"});
        EXPECT_GT(row["mrays_per_second"]["median"], 0) << row["name"];
        EXPECT_TRUE(row["ratio_to_embree"]["median"].is_null());  // no Embree in this run
        EXPECT_TRUE(row["gate"]["passed"]);
        EXPECT_EQ(row["seconds_samples"].size(), 2u);
    }
    EXPECT_EQ(measured.out.find('/' + std::string("tmp")), std::string::npos) << "no paths";
}

TEST(Bench, keeps_what_the_control_kernel_did_and_whether_the_run_is_void) {
    for (const bool strict : {true, false}) {
        const Call measured = small_bench({"--structure", "bvh", "--rays", "camera,random",
                                           "--void-above", strict ? "1e-9" : "1e9"});
        ASSERT_EQ(measured.code, 0) << measured.err;
        const Json document = measured.json();
        const Json& control = document["control"];
        expect_keys(control, {"blocks", "block_seconds", "median_seconds", "moved", "void_above"});
        EXPECT_EQ(control["blocks"], 4);
        EXPECT_GT(control["moved"], 0);
        EXPECT_EQ(control["void"], strict);
        EXPECT_EQ(document["rows"].size(), 2u);
        EXPECT_GT(document["streams"][0]["control_moved"], 0);
    }
}

TEST(Bench, compares_every_row_with_the_fastest_of_embree_s) {
    const Call measured =
        small_bench({"--structure", "bvh", "embree", "embree:kernel=single", "--rays", "camera"});
    if (measured.err.find("no structure 'embree'") != std::string::npos)
        GTEST_SKIP() << "Embree was not found when this was built";
    ASSERT_EQ(measured.code, 0) << measured.err;
    const Json document = measured.json();
    double best = 0;
    std::string name;
    for (const Json& row : document["rows"]) {
        const double rate = row["mrays_per_second"]["median"];
        if (row["structure"] != "bvh" && rate > best) {
            best = rate;
            name = row["structure"];
        }
    }
    for (const Json& row : document["rows"]) {
        EXPECT_EQ(row["best_embree"], name);
        if (row["structure"] == name) {
            EXPECT_EQ(row["ratio_to_best_embree"]["median"], 1);
        }
        EXPECT_GT(row["ratio_to_best_embree"]["low"], 0);
    }
    EXPECT_EQ(document["over_best_embree"]["means"].size(), 3u);
}

TEST(Bench, protocol_is_what_other_options_leave_open) {
    const Call measured =
        call({"bench", "--protocol", "speed", "--scene", "soup:count=50", "--structure", "bvh",
              "--size", "16x16", "--rays", "camera", "--json"});
    if (measured.err.find("no structure 'embree'") != std::string::npos)
        GTEST_SKIP() << "Embree was not found when this was built";
    const Json document = measured.json();
    EXPECT_EQ(document["settings"]["protocol"], "speed");
    EXPECT_EQ(document["settings"]["repetitions"], 15);
    EXPECT_EQ(document["streams"][0]["rays"], 16 * 16);
    ASSERT_GT(document["rows"].size(), 5u);
    EXPECT_EQ(document["rows"][0]["structure"], "bvh");
    EXPECT_EQ(document["rows"][0]["seconds_samples"].size(), 15u);
    EXPECT_EQ(document["rows"][1]["structure"], "embree");
}

TEST(Bench, builds_in_turns_with_the_threads_of_the_run) {
    for (const int threads : {1, 2}) {
        const Call measured = small_bench({"--structure", "lanes", "bvh", "--rays", "camera",
                                           "--builds", "4", "--threads", std::to_string(threads)});
        ASSERT_EQ(measured.code, 0) << measured.err;
        const Json document = measured.json();
        EXPECT_EQ(document["settings"]["builds"], 4);
        EXPECT_EQ(document["rows"][0]["bytes"], threads);
        for (const Json& row : document["rows"]) EXPECT_GE(row["build_samples"].size(), 4u);
    }
}

TEST(Bench, has_build_rate_and_peak_memory_or_null) {
    const Call measured = call({"bench", "--scene", "soup:count=30000", "--structure", "bvh",
                                "--rays", "random", "--size", "16x16", "--json"});
    ASSERT_EQ(measured.code, 0) << measured.err;
    const Json document = measured.json();
    const Json& row = document["rows"][0];
    const double rate = row["build_mprimitives_per_second"]["median"];
    EXPECT_NEAR(rate * row["build_seconds"].get<double>(), 0.03, 1e-6);
    if (!row["build_peak_bytes"].is_null()) {
        EXPECT_GT(row["build_peak_bytes"], row["bytes"]);
        EXPECT_LT(row["build_peak_bytes"], 4096 * 30000);
    }
    const Json tiny = small_bench({"--structure", "bvh", "--rays", "camera"}).json();
    EXPECT_TRUE(tiny["rows"][0]["build_peak_bytes"].is_null());
}

TEST(Bench, a_wrong_structure_is_an_error_row_and_never_timed) {
    const Call measured = small_bench({"--structure", "bvh", "wrong", "off", "--rays", "camera"});
    EXPECT_EQ(measured.code, 1);
    const Json document = measured.json();
    ASSERT_EQ(document["rows"].size(), 3u);
    for (const Json& row : document["rows"]) {
        if (row["structure"] == "bvh") continue;
        EXPECT_TRUE(row["error"].is_string()) << row["name"];
        EXPECT_TRUE(row["mrays_per_second"]["median"].is_null());
        EXPECT_TRUE(row["seconds_samples"].empty());
    }
}

TEST(Bench, row_runs_exactly_the_rows_it_names) {
    const std::string name = "rays/spd/tetra:size=2/bvh:leaf=1/shadow";
    const Call measured = call({"bench", "--row", name, "--row", "warm/spd/tetra:size=2/bvh/camera",
                                "--size", "24x24", "--repetitions", "1", "--json"});
    ASSERT_EQ(measured.code, 0) << measured.err;
    std::set<std::string> names;
    const Json document = measured.json();
    for (const Json& row : document["rows"]) names.insert(row["name"]);
    EXPECT_EQ(names, (std::set<std::string>{name, "warm/spd/tetra:size=2/bvh/camera"}));
}

TEST(Bench, counts_are_the_same_for_one_thread_and_two) {
    const Call one = small_bench({"--structure", "bvh", "--threads", "1"});
    const Call two = small_bench({"--structure", "bvh", "--threads", "2"});
    ASSERT_EQ(one.code, 0) << one.err;
    ASSERT_EQ(two.code, 0) << two.err;
    const Json a = one.json(), b = two.json();
    ASSERT_EQ(a["rows"].size(), b["rows"].size());
    for (std::size_t i = 0; i < a["rows"].size(); ++i) {
        EXPECT_EQ(a["rows"][i]["per_ray"], b["rows"][i]["per_ray"]);
        EXPECT_EQ(a["rows"][i]["gate"], b["rows"][i]["gate"]);
    }
}

TEST(Limits, of_a_tiny_scene_has_the_documented_keys) {
    const Call measured =
        call({"limits", "--scene", "soup:count=50", "--structure", "bvh8", "--rays", "random",
              "--size", "16x16", "--repetitions", "2", "--largest", "1", "--json"});
    ASSERT_EQ(measured.code, 0) << measured.err;
    const Json document = measured.json();
    EXPECT_EQ(document["document"], "limits");
    expect_keys(document["machine"], {"cycles_per_ns", "latency", "throughput"});
    EXPECT_EQ(document["machine"]["latency"].size(), 4u);
    ASSERT_EQ(document["costs"].size(), 2u);
    for (const Json& way : document["costs"]) {
        expect_keys(way, {"way", "structure", "ns_per_ray", "cycles_per_step", "cycles_per_leaf"});
        EXPECT_GT(way["ns_per_step"].get<double>() + way["ns_per_leaf"].get<double>(), 0);
        EXPECT_GE(way["residual"], 0);
        EXPECT_GT(way["samples"].size(), 8u);
    }
    ASSERT_EQ(document["bounds"].size(), 1u);
    EXPECT_GT(document["bounds"][0]["mrays_per_second"]["alone"], 0);
    ASSERT_EQ(document["shares"].size(), 3u);
    EXPECT_GT(document["shares"][2]["share"]["in flight"], 0);
}

TEST(Scaling, of_small_scenes_has_the_documented_keys) {
    const Call measured =
        call({"scaling", "--structure", "bvh", "--family", "tetra", "--most", "5000", "--rays",
              "random", "--size", "16x16", "--repetitions", "2", "--json"});
    ASSERT_EQ(measured.code, 0) << measured.err;
    const Json document = measured.json();
    EXPECT_EQ(document["document"], "scaling");
    EXPECT_EQ(document["families"], Json::array({"tetra"}));
    ASSERT_EQ(document["rows"].size(), 2u);
    ASSERT_EQ(document["exponents"].size(), 5u);
    for (const Json& entry : document["exponents"])
        expect_keys(entry, {"family", "structure", "quantity", "kind", "exponent", "standard_error",
                            "factor"});
    EXPECT_NEAR(document["exponents"][1]["exponent"], 1, 0.2);  // bytes
}

TEST(Scaling, of_unknown_scenes_says_what_there_is) {
    const Call refused = call({"scaling", "--structure", "bvh", "--family", "gears"});
    EXPECT_NE(refused.code, 0);
    EXPECT_NE(refused.err.find("tetra, balls, soup"), std::string::npos) << refused.err;
}

TEST(Report, makes_the_same_tables_again_from_raw_results) {
    const auto folder = fresh_folder("report");
    const std::string raw = (folder / "raw.json").string();
    ASSERT_EQ(small_bench({"--structure", "bvh", "--out", raw}).code, 0);
    const auto tables = folder / "tables";
    const Call reported = call({"report", raw, "--out", tables.string()});
    ASSERT_EQ(reported.code, 0) << reported.err;
    EXPECT_NE(reported.out.find("spd/tetra:size=2"), std::string::npos);
    for (const char* name : {"README.md", "comparison.md", "comparison.csv", "rows.csv"})
        EXPECT_TRUE(std::filesystem::exists(tables / name)) << name;
}

TEST(SeedQuestion, extrapolates_brute_force_and_says_so) {
    const Call asked =
        call({"seed-question", "--scene", "soup:count=2000", "--structure", "brute_force", "bvh",
              "--size", "150x150", "--repetitions", "1", "--json"});
    ASSERT_EQ(asked.code, 0) << asked.err;
    const Json rows = asked.json()["rows"];
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0]["object_tests"], 2000.0 * 150 * 150);
    EXPECT_TRUE(rows[0]["extrapolated"]);
    EXPECT_LT(rows[0]["measured_rays"], rows[0]["rays"]);
    EXPECT_FALSE(rows[1]["extrapolated"]);
    EXPECT_LT(rows[1]["object_tests"], rows[0]["object_tests"]);
}

TEST(Version, and_help_go_to_standard_output_with_exit_0) {
    for (const char* option : {"--version", "--help"}) {
        const Call asked = call({option});
        EXPECT_EQ(asked.code, 0) << option;
        EXPECT_FALSE(asked.out.empty()) << option;
    }
}

}  // namespace
}  // namespace rayshoot
