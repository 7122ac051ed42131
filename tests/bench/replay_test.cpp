#include "bench/replay/replay.h"
#include "tests/bench/command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

/// Published tables: how they are read, and how numbers are made and judged.
namespace rayshoot {
namespace {

const CountedByName some{{"hits", 4}, {"cells", 10}, {"empty_cells", 3}};

double measured(const char* text) { return Measure(text, some).of(some); }

TEST(Measure, adds_subtracts_multiplies_and_divides_once) {
    EXPECT_EQ(measured("cells"), 10);
    EXPECT_EQ(measured("cells/hits"), 2.5);
    EXPECT_EQ(measured("2*cells-empty_cells-hits/hits+cells"), 13.0 / 14);
}

TEST(Measure, names_what_is_not_counted_and_what_is) {
    try {
        measured("cells/rays");
        FAIL();
    } catch (const std::invalid_argument& wrong) {
        EXPECT_NE(std::string(wrong.what()).find("\"rays\""), std::string::npos);
        EXPECT_NE(std::string(wrong.what()).find("empty_cells"), std::string::npos);
    }
    EXPECT_THROW(measured(""), std::invalid_argument);
    EXPECT_THROW(measured("x*cells"), std::invalid_argument);
    EXPECT_THROW(measured("cells//hits"), std::invalid_argument);
}

const std::string header =
    "structure,setting,scene,metric,value,measure,tolerance,our_value,spec\n";

class Replay : public testing::Test {
protected:
    Call of(const std::string& text, const std::vector<std::string>& more = {}) {
        const auto path = fresh_folder("replay") / "table.csv";
        std::ofstream(path) << text;
        std::vector<std::string> arguments{"replay", "havran99", "--published", path.string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return call(arguments);
    }
};

TEST_F(Replay, judges_each_number_and_fails_where_one_is_off) {
    const Call good = of("# source\n" + header +
                             "bvh,leaf,soup:count=9,N,9,references,exact,,bvh:leaf=1\n"
                             "bvh,leaf,soup:count=9,M,9.1,references,2%,,bvh:leaf=1\n"
                             "bvh,leaf,soup:count=9,P,50,references,none,9,bvh:leaf=1\n"
                             "bvh,leaf,soup:count=9,Q,50,references,none,,bvh:leaf=1\n",
                         {"--json"});
    ASSERT_EQ(good.code, 0) << good.err;
    std::vector<std::string> verdicts;
    const auto document = good.json();
    for (const auto& number : document["numbers"]) verdicts.push_back(number["verdict"]);
    EXPECT_EQ(verdicts, (std::vector<std::string>{"exact", "within", "pinned", "open"}));

    const Call off = of(header + "bvh,leaf,soup:count=9,N,8,references,exact,,bvh:leaf=1\n");
    EXPECT_EQ(off.code, 1);
    EXPECT_NE(off.out.find("OFF"), std::string::npos);
    const Call changed = of(header + "bvh,leaf,soup:count=9,N,8,references,none,8,bvh:leaf=1\n");
    EXPECT_EQ(changed.code, 1);
    EXPECT_NE(changed.out.find("CHANGED"), std::string::npos);
}

TEST_F(Replay, says_file_line_and_remedy_for_what_is_wrong) {
    const std::vector<std::pair<std::string, std::string>> bad{
        {"", "table.csv:1: no numbers"},
        {"a,b,c\n", "table.csv:1: the first line should be structure,"},
        {header + "# note\na,b,c\n", "table.csv:3: there should be 9 fields"},
        {header + "a,b,c,d,much,leaves,exact,,bvh\n", "table.csv:2: the value"},
        {header + "a,b,c,d,1,leaves,near,,bvh\n", "table.csv:2: the tolerance"},
        {header + "a,b,,d,1,leaves,exact,,bvh\n", "table.csv:2: the scene is missing"},
        {header + "a,b,c,d,1,leaves,exact,,\"bvh\n", "table.csv:2: a quote"},
        {header + "a,b,spd/tetra,d,1,leafs,exact,,bvh\n", "table.csv:2: nothing is counted"},
        {header + "a,b,spd/nothing,d,1,leaves,exact,,bvh\n", "table.csv:2: "},
        {header + "a,b,soup:count=9,d,1,leaves,exact,,bvh:bins=x\n", "table.csv:2: "},
        {header + "a,b,soup:count=9,d,1,leaves,exact,,bhv\n", "table.csv:2: "},
        {header + "a,b,c,d,1,leaves,exact,,bvh\na,b,c,d,2,leaves,exact,,bvh\n",
         "table.csv:3: this number is given twice"}};
    for (const auto& [text, named] : bad) {
        const Call result = of(text);
        EXPECT_EQ(result.code, 2) << text;
        EXPECT_EQ(result.out, "") << text;
        EXPECT_NE(result.err.find(named), std::string::npos) << text << result.err;
    }
    EXPECT_EQ(call({"replay", "havran99", "--published", "no.csv"}).code, 2);
    EXPECT_EQ(call({"replay", "havran99", "--scene", "spd/nothing"}).code, 2);
    EXPECT_EQ(call({"replay", "somebody88"}).code, 2);
}

/// The rows of the shipped table that are quick to rebuild.
TEST(ReplayHavran99, tetra_to_depth_5) {
    PublishedTable table = read_published("data/published/havran99.csv");
    std::erase_if(table.numbers, [](const PublishedNumber& n) {
        return n.scene != "spd/tetra" || (n.setting != "md4" && n.setting != "md5");
    });
    ASSERT_GT(table.numbers.size(), 70u);
    for (const ReplayedNumber& number : replay(built_in_catalogue(), table, {}))
        EXPECT_FALSE(is_broken(number.verdict))
            << number.published.structure << ' ' << number.published.setting << ' '
            << number.published.metric << ": " << number.published.value << ", ours "
            << number.ours;
}

}  // namespace
}  // namespace rayshoot
