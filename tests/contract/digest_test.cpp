#include "tests/contract/hit_digest.h"

#include <gtest/gtest.h>

/// The committed digests hold for g++ and clang, for every preset and every machine. They change
/// when the kit's scenes or rays change, or the definition of a hit does: never by accident.
namespace rayshoot::contract {
namespace {

constexpr const char* golden_questions =
    "4894caa721ccaf7f5788c37f01e54b6040e10d3e0abd8e6fc2f9eaec1a5c3cd8";
constexpr const char* golden_hits =
    "03e5bb9d57827b3b37b087f16549f86a0e0c2bfd141f1629f7b0ea0b07ae9ce6";

TEST(Digest, of_the_questions_is_the_committed_one) {
    EXPECT_EQ(question_digest(make_cases({})), golden_questions);
}

TEST(Digest, of_the_answers_is_the_committed_one_for_every_exact_configuration) {
    const std::vector<Case> cases = make_cases({});
    const Catalogue catalogue = built_in_catalogue();
    for (const std::string& spec : exact_configurations(catalogue))
        EXPECT_EQ(hit_digest(catalogue, spec, cases), golden_hits) << spec;
}

}  // namespace
}  // namespace rayshoot::contract
