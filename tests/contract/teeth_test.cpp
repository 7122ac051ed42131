#include "tests/contract/contract.h"
#include "tests/contract/structures/test_tree/test_tree.h"
#include "tests/contract/test_catalogue.h"

#include <gtest/gtest.h>

/// The kit has teeth: each planted fault is found, and the same structure without one passes.
namespace rayshoot::contract {
namespace {

class PlantedFault : public testing::TestWithParam<std::string_view> {};

TEST_P(PlantedFault, is_found) {
    const std::string spec = "test_tree:fault=" + std::string(GetParam());
    const Report report = run_contract(test_catalogue(), spec, {.enough_failures = 1});
    EXPECT_GT(report.failures, 0u) << spec << " got through: " << report;
}

INSTANTIATE_TEST_SUITE_P(Kit, PlantedFault, testing::ValuesIn(fault_names()),
                         [](const auto& fault) { return std::string(fault.param); });

TEST(Kit, passes_the_same_structure_without_a_fault) {
    const Report report = run_contract(test_catalogue(), "test_tree", {});
    EXPECT_TRUE(report.passed()) << report;
}

TEST(Kit, prints_what_failed_so_that_it_can_be_repeated) {
    Settings settings;
    settings.scenes = {"cube"};
    const Report report = run_contract(test_catalogue(), "test_tree:fault=wrong_tie", settings);
    ASSERT_FALSE(report.messages.empty());
    const std::string& message = report.messages.front();
    for (const char* part : {"test_tree:fault=wrong_tie on cube, precision ", "seed 0x5eed",
                             "ray{(", "0x1", "brute force hit{"})
        EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
}

}  // namespace
}  // namespace rayshoot::contract
