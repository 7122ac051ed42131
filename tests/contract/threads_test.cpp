#include "tests/contract/checks/checks.h"
#include "tests/contract/contract.h"

#include <gtest/gtest.h>

/// For ThreadSanitizer, under which the whole contract takes too long: sessions of one structure on
/// two threads.
namespace rayshoot::contract {
namespace {

class EveryConfiguration : public testing::TestWithParam<std::string> {};

TEST_P(EveryConfiguration, answers_two_threads_at_once) {
    static const Case tested = make_cases({.scenes = {"mixed"}, .tests_per_scene = 0}).front();
    Report report;
    check_threads(*build(built_in_catalogue(), GetParam(), tested.scene.input()), tested, report);
    EXPECT_TRUE(report.passed()) << report;
    EXPECT_GT(report.answers, 0u);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryConfiguration,
                         testing::ValuesIn(exact_configurations(built_in_catalogue())));

}  // namespace
}  // namespace rayshoot::contract
