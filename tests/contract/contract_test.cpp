#include "tests/contract/contract.h"

#include <gtest/gtest.h>

/// Every exact configuration of the catalogue on every hard scene. The catalogue is read when the
/// program runs: a new line of it is picked up with no edit here.
namespace rayshoot::contract {
namespace {

class EveryConfiguration : public testing::TestWithParam<std::string> {};

TEST_P(EveryConfiguration, answers_like_brute_force) {
    const Report report = run_contract(built_in_catalogue(), GetParam(), {});
    EXPECT_TRUE(report.passed()) << GetParam() << ": " << report;
}

/// GoogleTest allows only letters, digits and underscores.
std::string test_name(const testing::TestParamInfo<std::string>& spec) {
    std::string name = spec.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryConfiguration,
                         testing::ValuesIn(exact_configurations(built_in_catalogue())), test_name);

}  // namespace
}  // namespace rayshoot::contract
