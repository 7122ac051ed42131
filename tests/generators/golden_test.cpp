#include "tests/generators/golden.h"

#include <gtest/gtest.h>

#include <fstream>

namespace rayshoot {
namespace {

TEST(Golden, every_generated_scene_has_the_committed_digest) {
    std::ifstream file("tests/generators/digests.csv");
    std::string line;
    ASSERT_TRUE(std::getline(file, line)) << "tests/generators/digests.csv is missing or empty";
    EXPECT_EQ(line, golden_header);
    for (const std::string& scene : golden_scenes()) {
        ASSERT_TRUE(std::getline(file, line)) << scene << " has no line";
        EXPECT_EQ(line, golden_line(scene));
    }
    EXPECT_FALSE(std::getline(file, line)) << "a line too many: " << line;
}

}  // namespace
}  // namespace rayshoot
