#include "tests/contract/hit_digest.h"

#include <gtest/gtest.h>

/// The committed digests hold for g++ and clang, for every preset and every machine. They change
/// when the kit's scenes or rays change, or the definition of a hit does: never by accident.
namespace rayshoot::contract {
namespace {

constexpr const char* golden_questions =
    "a73e8cef2ee43cb1e7ff1cdbb3be15d0745055f04bfc7dbe5729e5859639eee4";
constexpr const char* golden_hits =
    "dae405d27ddbf8612b68421e7d4546d8f24cc2b5121dac38aac4722c9a373d8a";

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
