#include "bench/comparison/row_name.h"
#include "bench/comparison/plan.h"

#include <gtest/gtest.h>

namespace rayshoot {
namespace {

TEST(RowName, parses_back_to_what_it_was_made_of) {
    for (const RowName& name : {RowName{"rays", "spd/gears", "vista_buffer+bvh", "camera"},
                                RowName{"warm", "soup:count=10,seed=2", "bvh:leaf=1", "diffuse"},
                                RowName{"rays", "../models/a b.ply:loop=2", "bvh", "random"},
                                RowName{"build", "spd/balls", "grid:density=3,mailbox=on", ""}}) {
        EXPECT_EQ(parse_row_name(to_string(name)), name);
    }
}

TEST(RowName, anything_else_is_refused) {
    for (const char* text : {"", "rays", "rays/", "rays/spd", "rays/spd/bvh", "rays/spd/bvh/",
                             "x/a/b/c", "rays/spd/balls/bvh/sideways", "rays//bvh/camera"}) {
        EXPECT_THROW(parse_row_name(text), std::invalid_argument) << text;
    }
}

TEST(Rows, narrow_a_plan_to_exactly_themselves) {
    ComparisonPlan plan;
    narrow_to_rows(plan, {"rays/spd/balls/a+b/camera", "rays/spd/gears/a/shadow",
                          "rays/spd/balls/a+b/camera"});
    EXPECT_EQ(plan.scenes, (std::vector<std::string>{"spd/balls", "spd/gears"}));
    EXPECT_EQ(plan.structures, (std::vector<std::string>{"a+b", "a"}));
    EXPECT_TRUE(plan.wants("rays/spd/balls/a+b/camera"));
    EXPECT_FALSE(
        plan.wants("rays/spd/balls/aab/camera"));  // as a regular expression it would match
    EXPECT_FALSE(plan.wants("rays/spd/balls/a/camera"));
}

}  // namespace
}  // namespace rayshoot
