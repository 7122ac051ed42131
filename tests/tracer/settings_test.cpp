#include "tracer/settings.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tracer/lens.h"

namespace rayshoot {
namespace {

ImageSettings applied(const std::string& text) {
    ImageSettings settings;
    apply_settings(text, settings);
    return settings;
}

/// What is said of `text`.
std::string refusal(const std::string& text) {
    try {
        applied(text);
    } catch (const std::invalid_argument& wrong) {
        return wrong.what();
    }
    return {};
}

std::string file_with(const std::string& text) {
    const auto path = std::filesystem::path(testing::TempDir()) / "settings_test.txt";
    std::ofstream(path) << text;
    return path.string();
}

TEST(Settings, of_the_issue_are_understood) {
    const ImageSettings settings =
        applied("filter=cone,radius=1.7,sampler=jitter,spp=16,lens=f2.8");
    EXPECT_EQ(settings.render.filter.kind, FilterKind::cone);
    EXPECT_EQ(settings.render.filter.radius, 1.7);
    EXPECT_EQ(settings.render.sampler, SamplerKind::jitter);
    EXPECT_EQ(settings.render.format.spp, 16);
    EXPECT_EQ(settings.f_stop, 2.8f);
}

TEST(Settings, of_a_file_are_those_of_the_command_line) {
    const std::string file = file_with(
        "# a comment\n\n  filter = hann , radius = 1.6  # and another\nmethod = path\r\ndepth=9\n");
    const ImageSettings settings = applied("@" + file);
    EXPECT_EQ(settings.render.filter.kind, FilterKind::raised_cosine);
    EXPECT_EQ(settings.render.filter.radius, 1.6);
    EXPECT_EQ(settings.render.transport.method, Method::path);
    EXPECT_EQ(settings.render.transport.depth, 9);
}

TEST(Settings, given_later_replace_earlier_ones) {
    ImageSettings settings;
    apply_settings("spp=4,depth=3", settings);
    apply_settings("spp=9", settings);
    EXPECT_EQ(settings.render.format.spp, 9);
    EXPECT_EQ(settings.render.transport.depth, 3);
}

TEST(Settings, that_are_unknown_are_refused_with_a_list) {
    const std::string said = refusal("colour=blue");
    EXPECT_NE(said.find("colour"), std::string::npos);
    for (const char* key : {"filter=", "radius=", "sampler=", "spp=", "lens=", "method="})
        EXPECT_NE(said.find(key), std::string::npos) << key;
}

TEST(Settings, that_make_no_sense_are_refused) {
    for (const char* text : {"spp",           "spp=",           "=3",
                             "spp=0",         "spp=65537",      "spp=3.5",
                             "spp=x",         "spp=nan",        "radius=0.4",
                             "radius=17",     "radius=inf",     "filter=sharp",
                             "sampler=lucky", "method=magic",   "depth=0",
                             "depth=256",     "lens=2.8mm",     "lens=f0",
                             "blades=-1",     "open=2",         "tolerance=0",
                             "spp=1,spp=2",   "spp=4,,depth=3", "reconstruct=",
                             "order=white",   "adaptive=maybe"})
        EXPECT_NE(refusal(text), "") << text;
}

TEST(Settings, of_a_file_are_refused_with_its_line) {
    const std::string file = file_with("spp=4\n\ndepth=none\n");
    EXPECT_EQ(refusal("@" + file).rfind(file + ":3: ", 0), 0u) << refusal("@" + file);
    EXPECT_NE(refusal("@" + testing::TempDir()), "");
    EXPECT_NE(refusal("@/nowhere/at/all"), "");
}

TEST(Settings, put_a_lens_on_a_camera_that_has_none) {
    Camera camera;
    camera.from = {0, 0, 10};
    camera.at = {0, 0, 0};
    apply_to(camera, applied("lens=f2,focus=8,blades=6"));
    ASSERT_TRUE(camera.lens);
    EXPECT_EQ(camera.lens->f_stop, 2);
    EXPECT_EQ(camera.lens->focus_distance, 8);
    EXPECT_EQ(camera.lens->blades, 6);
    Camera pinhole;
    EXPECT_THROW(apply_to(pinhole, applied("focus=3")), std::invalid_argument);
    EXPECT_THROW(apply_to(camera, applied("focus=0.01")), std::invalid_argument);
    apply_to(pinhole, applied("spp=4"));
    EXPECT_FALSE(pinhole.lens);
}

TEST(Settings, describe_every_key_they_take) {
    const std::string described = describe_settings();
    for (const char* key :
         {"spp",           "seed",      "sampler", "order", "time",     "filter",  "radius",
          "reconstruct",   "method",    "rules",   "depth", "roulette", "gather",  "cache_error",
          "light_samples", "lens",      "focal",   "focus", "blades",   "open",    "close",
          "shutter",       "tolerance", "least",   "round", "most",     "adaptive"})
        EXPECT_NE(described.find(std::string(key) + "="), std::string::npos) << key;
}

}  // namespace
}  // namespace rayshoot
