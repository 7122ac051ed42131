#include "tests/bench/command.h"

#include <gtest/gtest.h>

#include <fstream>

/// Bad input gets exit code 2, a message that names what is wrong, nothing on standard output, and
/// writes no file.
namespace rayshoot {
namespace {

struct BadInput {
    std::vector<std::string> arguments;  ///< OUT stands for a file in an empty folder
    std::string named;                   ///< must stand in the message
};

const std::vector<std::string> check{"check", "--structure", "bvh", "--scene", "soup:count=9"};
const std::vector<std::string> render{"render", "--structure", "bvh", "--scene", "soup:count=9"};
const std::vector<std::string> heatmap{"heatmap", "--scene", "soup:count=9", "--size",
                                       "4x4",     "--out",   "OUT"};
const std::vector<std::string> bench{"bench", "--structure", "bvh", "--scene", "soup:count=9"};

std::vector<std::string> with(std::vector<std::string> base, const std::vector<std::string>& more) {
    base.insert(base.end(), more.begin(), more.end());
    return base;
}

std::vector<BadInput> table() {
    return {
        {{}, "subcommand"},
        {{"dance"}, "subcommand"},
        {{"list", "--frobnicate"}, "frobnicate"},
        {{"count", "--structure", "bvh"}, "--scene"},
        {{"count", "--scene", "spd/tetra"}, "--structure"},
        {{"count", "--scene", "spd/nothing", "--structure", "bvh"}, "nothing"},
        {{"count", "--scene", "", "--structure", "bvh"}, ""},
        {{"count", "--scene", "soup:count=9", "--structure", "octopus"}, "octopus"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh:leaves=2"}, "leaves"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh:leaf=many"}, "many"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh+bvh"}, "bvh"},
        {{"count", "--scene", "soup:count=9", "--structure", ""}, "structure"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--size", "0x10"}, "0x10"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--size", "10"}, "10"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--size", "9x9x9"}, "9x9x9"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--size", "-3x4"}, "-3x4"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--size", "30000x30000"},
         "30000"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--size", "99999999999x2"},
         "999"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--spp", "0"}, "0"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--spp", "ten"}, "ten"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--rules", "mine"}, "mine"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--rays-file", "no.rays"},
         "no.rays"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--batch", "0"}, "batch"},
        {{"count", "--scene", "soup:count=9", "--structure", "bvh", "--batch", "5000"}, "4096"},
        {with(heatmap, {"--structure", "squid"}), "squid"},
        {with(heatmap, {}), "--structure"},
        {with(heatmap, {"--structure", "bvh", "--quantity", "love"}), "love"},
        {with(heatmap, {"--structure", "bvh", "--scale", "cubic"}), "cubic"},
        {with(heatmap, {"--structure", "bvh", "--top", "-1"}), "--top"},
        {with(heatmap, {"--structure", "bvh", "--repetitions", "0"}), "--repetitions"},
        {with(check, {"--rays", "0"}), "0"},
        {with(check, {"--rays", "-5"}), "-5"},
        {with(check, {"--rays", "99999999999"}), "99999999999"},
        {with(check, {"--seed", "abc"}), "abc"},
        {with(check, {"--threads", "0"}), "0"},
        {with(render, {"--size", "8x8"}), "--out"},
        {with(render, {"--size", "8x8", "--out", "OUT.jpg"}), "jpg"},
        {with(render, {"--size", "8x8", "--out", "no/such/folder/a.png"}), "no/such/folder"},
        {with(render, {"--size", "8x8", "--threads", "-1", "--out", "OUT.png"}), "-1"},
        {{"render", "--scene", "soup:count=9", "--structure", "squid", "--out", "OUT.png"},
         "squid"},
        {{"rays", "--scene", "soup:count=9", "--kind", "sideways", "--out", "OUT.rays"},
         "sideways"},
        {{"rays", "--scene", "soup:count=9", "--size", "20000x20000", "--out", "OUT.rays"},
         "20000"},
        {{"rays", "--scene", "soup:count=9", "--out", "no/such/folder/a.rays"}, "no/such/folder"},
        {{"rays", "--scene", "soup:count=9", "--out", ""}, "name"},
        {{"rays", "--scene", "soup:count=9", "--out", "/dev/null"}, "/dev/null"},
        {{"bench", "--structure", "bvh"}, "--scene"},
        {with(bench, {"--rays", "camera,sideways", "--out", "OUT.json"}), "sideways"},
        {with(bench, {"--repetitions", "0", "--out", "OUT.json"}), "0"},
        {with(bench, {"--batch", "5000"}), "5000"},
        {with(bench, {"--threads", "100000"}), "100000"},
        {with(bench, {"--row", "bvh"}), "bvh"},
        {with(bench, {"--row", "rays/soup:count=9/bvhh/camera"}), "bvhh"},
        {with(bench, {"--builds", "0"}), "builds"},
        {with(bench, {"--void-above", "0"}), "--void-above"},
        {with(bench, {"--void-above", "nan"}), "--void-above"},
        {{"bench", "--protocol", "fastest"}, "speed, subdivision"},
        {with(bench, {"--protocol", "speed", "--repetitions", "14"}), "15"},
        {{"limits"}, "--scene"},
        {{"limits", "--scene", "soup:count=9", "--largest", "0"}, "--largest"},
        {{"limits", "--scene", "soup:count=9", "--alone", "octopus"}, "octopus"},
        {{"limits", "--scene", "soup:count=9", "--structure", "squid"}, "squid"},
        {{"limits", "--scene", "soup:count=9", "--rays", "sideways"}, "sideways"},
        {{"limits", "--scene", "soup:count=9", "--repetitions", "0"}, "0"},
        {{"report"}, "raw"},
        {{"report", "no.json"}, "no.json"},
        {{"report", "README.md"}, "README.md"},
        {{"report", "CMakePresets.json"}, "schema"},
        {{"seed-question", "--size", "0x0"}, "0x0"},
    };
}

TEST(BadInput, is_named_with_exit_code_2_and_writes_nothing) {
    const auto folder = fresh_folder("bad");
    for (BadInput bad : table()) {
        std::string line;
        for (std::string& argument : bad.arguments) {
            if (argument.starts_with("OUT")) argument = (folder / argument).string();
            line += " " + argument;
        }
        const Call called = call(bad.arguments);
        EXPECT_EQ(called.code, 2) << line;
        EXPECT_FALSE(called.err.empty()) << line;
        EXPECT_NE(called.err.find(bad.named), std::string::npos) << line << "\n" << called.err;
        EXPECT_EQ(called.out, "") << line;
        EXPECT_TRUE(std::filesystem::is_empty(folder)) << line;
    }
}

TEST(BadInput, with_json_leaves_standard_output_empty) {
    const Call called = call({"count", "--scene", "nowhere", "--structure", "bvh", "--json"});
    EXPECT_EQ(called.code, 2);
    EXPECT_EQ(called.out, "");
}

}  // namespace
}  // namespace rayshoot
