#include "tests/contract/contract.h"
#include "tests/contract/truth.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rayshoot::contract {
namespace {

std::uint64_t valid_rays(const Stream& stream) {
    return static_cast<std::uint64_t>(std::count_if(stream.rays.begin(), stream.rays.end(), valid));
}

TEST(BruteForce, tests_every_primitive_once_for_every_closest_ray) {
    for (const Case& tested : make_cases({})) {
        const auto accel = build(built_in_catalogue(), "brute_force", tested.scene.input());
        const auto session = accel->open(Mode::counting);
        const Stream& stream = tested.hard_rays();
        std::vector<Hit> hits(max_batch);
        for (std::size_t first = 0; first < stream.size(); first += max_batch)
            session->closest(stream.batch(first, std::min(max_batch, stream.size() - first)), hits);
        EXPECT_EQ((*session->counters(stream.kind))[Event::object_test],
                  valid_rays(stream) * tested.scene.geometry.size())
            << tested.name();
    }
}

TEST(BruteForce, holds_each_primitive_once) {
    for (const Recipe& recipe : hard_scenes()) {
        const HardScene scene = hard_scene(recipe, Precision::standard);
        const auto accel = build(built_in_catalogue(), "brute_force", scene.input());
        EXPECT_EQ(accel->footprint().references, scene.geometry.size()) << scene.name;
    }
}

}  // namespace
}  // namespace rayshoot::contract
