#include "data/generators/generators.h"

#include "data/generators/newell.h"
#include "data/generators/printer.h"
#include "data/generators/random.h"
#include "tests/generators/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rayshoot {
namespace {

/// That the scene is refused with a message in which `word` occurs.
testing::AssertionResult refuses(std::string_view scene, std::string_view word) {
    try {
        generate_scene(scene);
    } catch (const std::invalid_argument& error) {
        if (std::string_view(error.what()).find(word) != std::string_view::npos)
            return testing::AssertionSuccess();
        return testing::AssertionFailure() << error.what();
    }
    return testing::AssertionFailure() << scene << " was made";
}

std::uint32_t size(std::string_view scene) { return generate_scene(scene).geometry.size(); }

TEST(Generators, an_unknown_name_lists_what_exists) {
    EXPECT_TRUE(refuses("spd/sphereflake", "spd/balls"));
    EXPECT_FALSE(is_generator("spd/sphereflake"));
    EXPECT_TRUE(is_generator("spd/balls"));
}

TEST(Generators, an_unknown_option_lists_what_exists) {
    EXPECT_TRUE(refuses("soup:size=3", "count"));
    EXPECT_TRUE(refuses("chair:size=3", "size"));
}

TEST(Generators, a_size_too_large_names_the_largest) {
    EXPECT_TRUE(refuses("spd/tetra:size=30", "11"));
    EXPECT_TRUE(refuses("soup:count=2000000000", "4000000"));
    EXPECT_TRUE(refuses("needles:aspect=10", "1000"));
    EXPECT_TRUE(refuses("spd/balls:size=0", "1"));
    EXPECT_TRUE(refuses("spd/balls:size=2.5", "whole"));
}

TEST(Generators, every_default_is_in_its_own_range) {
    for (const GeneratorInfo& info : generators())
        for (const GeneratorOption& option : info.options) {
            EXPECT_LE(option.lowest, option.fallback) << info.name << ' ' << option.name;
            EXPECT_LE(option.fallback, option.highest) << info.name << ' ' << option.name;
        }
}

TEST(Generators, counts_follow_the_formulas_of_the_readme) {
    EXPECT_EQ(size("spd/balls:size=3"), (9u * 9 * 9 * 9 - 1) / 8 + 1);
    EXPECT_EQ(size("spd/gears:size=3"), 146u * 27 + 1);
    EXPECT_EQ(size("spd/mount:size=3"), 2u * 64 + 4);
    EXPECT_EQ(size("spd/rings:size=3"), 10u * 3 * 4 * 7 + 1);
    EXPECT_EQ(size("spd/teapot:size=3"), 65u * 9 - 8 * 3);
    EXPECT_EQ(size("spd/tetra:size=3"), 64u);
    EXPECT_EQ(size("spd/tree:size=3"), 2u * 15 + 1);
    EXPECT_EQ(size("spd/lattice:size=3"), 64u + 3 * 3 * 16);
    EXPECT_EQ(size("spd/shells:size=3"), 180u * 8 + 1);
    EXPECT_EQ(size("spd/jacks:size=3"), 9u * (512 - 1) / 7);
    EXPECT_EQ(size("spd/sombrero:size=2"), 2u * 63 * 63);
    EXPECT_EQ(size("soup:count=10"), 10u);
    EXPECT_EQ(size("needles:count=10"), 10u);
    EXPECT_EQ(size("stadium:size=3"), 64u * 9 - 8 * 3 + 1088);
    EXPECT_EQ(size("chair"), 96u);
}

TEST(Generators, every_primitive_has_a_material_and_a_finite_box) {
    for (const GeneratorInfo& info : generators()) {
        const Scene scene = generate_scene(info.name);
        EXPECT_EQ(scene.name, info.name);
        ASSERT_EQ(scene.material_of.size(), scene.geometry.size()) << info.name;
        EXPECT_LT(*std::ranges::max_element(scene.material_of), scene.materials.size());
        EXPECT_FALSE(scene.lights.empty()) << info.name;
        EXPECT_TRUE(finite(scene.geometry.bounds().lo) && finite(scene.geometry.bounds().hi));
    }
}

TEST(Generators, precision_reaches_the_geometry) {
    EXPECT_EQ(generate("spd/jacks", {}, Precision::watertight).geometry.precision(),
              Precision::watertight);
    EXPECT_EQ(generate("spd/jacks", {}).geometry.precision(), Precision::standard);
}

TEST(Printer, numbers_are_what_six_printed_digits_read_back_as) {
    using procedural::printed;
    EXPECT_EQ(printed(1.0 / 3), 0.333333f);
    EXPECT_EQ(printed(-2.55836123e-17), -2.55836e-17f);
    EXPECT_EQ(printed(1234567), 1.23457e6f);
    EXPECT_EQ(printed(100000.4), 100000.0f);
    EXPECT_TRUE(std::signbit(printed(-0.0)));
    EXPECT_EQ(printed(-1e-60), 0.0f);
}

TEST(Random, an_item_does_not_depend_on_the_others) {
    const Scene few = generate_scene("soup:count=10"), many = generate_scene("soup:count=100");
    for (std::size_t i = 0; i < few.geometry.vertices().size(); ++i)
        EXPECT_EQ(few.geometry.vertices()[i], many.geometry.vertices()[i]);
}

/// Null hypothesis: places are uniform in the cube. Chi-squared over 8^3 cells, 511 degrees of
/// freedom, 51200 draws; rejected beyond 660, about the level 1e-5.
TEST(Random, places_fill_the_cube_evenly) {
    std::vector<int> cells(512);
    constexpr int draws = 51200;
    for (std::uint64_t item = 0; item < draws; ++item) {
        const dvec3 p = procedural::Random(1, item).place() * 8.0;
        ++cells[static_cast<std::size_t>(p.x) * 64 + static_cast<std::size_t>(p.y) * 8 +
                static_cast<std::size_t>(p.z)];
    }
    double chi_squared = 0;
    for (const int count : cells) chi_squared += (count - 100.0) * (count - 100.0) / 100.0;
    EXPECT_LT(chi_squared, 660);
    EXPECT_GT(chi_squared, 380);
}

TEST(Soup, edges_have_the_asked_length) {
    const Scene scene = generate_scene("soup:count=1000,length=0.25,seed=3");
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Triangle t = scene.geometry.triangle(i);
        EXPECT_NEAR(length(t.b - t.a), 0.25f, 1e-6f);
        EXPECT_NEAR(length(t.c - t.b), 0.25f, 1e-6f);
        EXPECT_NEAR(length(t.a - t.c), 0.25f, 1e-6f);
    }
}

TEST(Needles, width_is_length_over_aspect) {
    const Scene scene = generate_scene("needles:count=1000,aspect=10000");
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Triangle t = scene.geometry.triangle(i);
        EXPECT_NEAR(length(t.b - t.a), 1e-4f, 1e-6f);
        EXPECT_NEAR(length(t.c - t.a), 1, 1e-6f);
    }
}

TEST(Stadium, is_thousands_of_times_as_wide_as_its_teapot) {
    const Scene scene = generate_scene("stadium");
    EXPECT_GT(scene.geometry.bounds().size().x, 23999);
    Box teapot;
    for (std::uint32_t i = 1088; i < scene.geometry.size(); ++i)
        teapot.include(scene.geometry.bounds(i));
    EXPECT_LT(teapot.size().x, 6.5f);
}

TEST(Teapot, neighbouring_patches_share_their_border) {
    const auto patches = procedural::newell_patches();
    for (const std::size_t first : {0u, 4u, 8u, 20u, 24u, 28u})
        for (std::size_t quarter = 0; quarter < 4; ++quarter)
            for (std::size_t row = 0; row < 4; ++row)
                EXPECT_EQ(patches[first + quarter][row][3],
                          patches[first + (quarter + 1) % 4][row][0]);
}

}  // namespace
}  // namespace rayshoot
