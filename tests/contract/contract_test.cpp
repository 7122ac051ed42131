#include "tests/contract/contract.h"

#include <gtest/gtest.h>

/// Every exact configuration of the catalogue on every hard scene. The catalogue is read when the
/// program runs: a new line of it is picked up with no edit here.
namespace rayshoot::contract {
namespace {

class EveryConfiguration : public testing::TestWithParam<std::string> {};

TEST_P(EveryConfiguration, answers_like_brute_force) {
    static const Contract contract;
    const Report report = contract.run(built_in_catalogue(), GetParam());
    EXPECT_TRUE(report.passed()) << GetParam() << ": " << report;
}

/// Rays that go together: structures take them another way than rays alone.
TEST_P(EveryConfiguration, finds_nothing_in_nothing_for_rays_that_go_together) {
    const Geometry geometry = GeometryBuilder().build();
    const BuildInput input{geometry};
    const auto structure = build(built_in_catalogue(), GetParam(), input);
    const auto session = structure->open(Mode::timing);
    std::vector<Ray> rays(200);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const float step = 0.001f * static_cast<float>(i % 16);
        rays[i] = {.origin = vec3(0), .direction = {1, 0.5f + step, 0.25f + step}};
    }
    const RayBatch batch{RayKind::camera, 0, rays, {}};
    std::vector<Hit> hits(rays.size(), Hit{1, 1, 1, 1});
    std::vector<std::uint8_t> occluded(rays.size(), 1);
    session->closest(batch, hits);
    session->occluded(batch, occluded);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(hits[i].primitive, no_primitive);
        EXPECT_EQ(occluded[i], 0);
    }
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
