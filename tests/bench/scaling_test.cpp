#include "bench/scaling/scaling.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

TEST(Scaling, scenes_of_a_family_are_those_that_are_small_enough) {
    const std::vector<std::string> tetra{"spd/tetra:size=5", "spd/tetra:size=6"};
    EXPECT_EQ(scenes_of_family("tetra", 5000), tetra);
    EXPECT_EQ(scenes_of_family("balls", 1.1e6).size(), 4u);
    EXPECT_EQ(scenes_of_family("soup", 1e6).back(), "soup:count=1000000");
}

TEST(Scaling, of_one_scene_or_of_what_does_not_grow_is_refused) {
    EXPECT_THROW(scenes_of_family("tetra", 2000), std::invalid_argument);
    EXPECT_THROW(scenes_of_family("soup", std::nan("")), std::invalid_argument);
    EXPECT_THROW(scenes_of_family("gears", 1e6), std::invalid_argument);
}

/// A row whose costs grow as given powers of its size.
Row row(const std::string& scene, double primitives) {
    Row row;
    row.name = {"rays", scene, "grid", "random"};
    row.primitives = static_cast<std::uint64_t>(primitives);
    row.rays = row.timed_rays = 10;
    row.build_samples = {1e-6 * primitives};
    row.footprint.bytes = static_cast<std::uint64_t>(64 * primitives);
    const double rate = 100 / std::cbrt(primitives);
    row.mrays_per_second = Estimate{rate, rate, rate};
    return row;
}

TEST(Scaling, exponents_are_those_of_each_quantity) {
    ScalingPlan plan;
    plan.families = {"tetra"};
    choose_scenes(plan);
    Comparison comparison;
    double primitives = 1024;
    for (const std::string& scene : plan.comparison.scenes) {
        comparison.rows.push_back(row(scene, primitives));
        primitives *= 4;
    }
    comparison.rows.push_back(row("soup:count=1000", 17));  // of no family that was asked for
    const Json exponents = to_document(plan, comparison)["exponents"];
    const auto exponent = [&](const char* quantity) -> Json {
        for (const Json& entry : exponents)
            if (entry["quantity"] == quantity) return entry["exponent"];
        return "missing";
    };
    EXPECT_EQ(exponents.size(), 5u);
    EXPECT_NEAR(exponent("build_seconds"), 1, 1e-9);
    EXPECT_NEAR(exponent("bytes"), 1, 1e-9);
    EXPECT_NEAR(exponent("seconds_per_ray"), 1.0 / 3, 1e-9);
    EXPECT_TRUE(exponent("steps_per_ray").is_null());  // not counted
}

}  // namespace
}  // namespace rayshoot
