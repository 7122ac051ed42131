#include "tests/bench/command.h"

#include <gtest/gtest.h>

/// All of Havran's tables. A scene takes a minute or a few.
namespace rayshoot {
namespace {

class ReplayAllOfHavran99 : public testing::TestWithParam<const char*> {};

TEST_P(ReplayAllOfHavran99, keeps_every_tolerance) {
    const Call result = call({"replay", "havran99", "--scene", std::string("spd/") + GetParam()});
    EXPECT_EQ(result.code, 0) << result.out << result.err;
}

INSTANTIATE_TEST_SUITE_P(Spd, ReplayAllOfHavran99,
                         testing::Values("balls", "gears", "mount", "tetra", "tree"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace rayshoot
