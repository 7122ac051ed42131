#include "tests/bench/command.h"
#include "tracer/colour_map.h"

#include <gtest/gtest.h>

#include <fstream>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

/// Two images that differ in one pixel of twelve, by 0.5 in one channel.
class Difference : public testing::Test {
protected:
    Difference() {
        Image a(4, 3), b(4, 3);
        b.at(2, 1).y = 0.5f;
        write_image(a, folder_ / "a.exr");
        write_image(b, folder_ / "b.exr");
        write_image(b, folder_ / "b.png");
        write_image(Image(3, 4), folder_ / "turned.exr");
    }
    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    std::filesystem::path folder_ = fresh_folder("difference");
};

TEST_F(Difference, of_equal_images_is_none_and_exits_with_0) {
    const Call same = call({"difference", file("a.exr"), file("a.exr")});
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_EQ(same.out, "the images are equal\n");
}

TEST_F(Difference, is_counted_and_exits_with_1) {
    const Call apart = call({"difference", file("a.exr"), file("b.exr"), "--json"});
    EXPECT_EQ(apart.code, 1) << apart.err;
    const Json document = apart.json();
    EXPECT_EQ(document["pixels"], 12);
    EXPECT_EQ(document["differing"], 1);
    EXPECT_EQ(document["largest"], 0.5);
    EXPECT_EQ(document["largest_at"], Json::parse("[2, 1]"));
    EXPECT_NEAR(document["rms"].get<double>(), 0.5 / 6, 1e-15);
    const Call told = call({"difference", file("a.exr"), file("b.exr")});
    EXPECT_NE(told.out.find("1 of 12 pixels differ"), std::string::npos) << told.out;
}

TEST_F(Difference, within_the_tolerance_exits_with_0_and_is_still_told) {
    const Call near =
        call({"difference", file("a.exr"), file("b.exr"), "--tolerance", "0.5", "--json"});
    EXPECT_EQ(near.code, 0) << near.err;
    EXPECT_EQ(near.json()["largest"], 0.5);
    EXPECT_EQ(near.json()["differing"], 0);
}

TEST_F(Difference, a_png_is_compared_in_linear_light) {
    const Call apart = call({"difference", file("b.exr"), file("b.png"), "--json"});
    EXPECT_EQ(apart.code, 1);
    EXPECT_LT(apart.json()["largest"], 0.003);  // of eight bits
}

TEST_F(Difference, image_is_signed_numbers_or_colours) {
    EXPECT_EQ(call({"difference", file("a.exr"), file("b.exr"), "--out", file("d.exr")}).code, 1);
    EXPECT_EQ(read_image(file("d.exr")).at(2, 1), vec3(0, -0.5f, 0));
    EXPECT_EQ(call({"difference", file("a.exr"), file("b.exr"), "--out", file("d.png")}).code, 1);
    const Image colours = read_image(file("d.png"));
    EXPECT_LT(length(colours.at(2, 1) - map_colour(1)), 0.01f);
    EXPECT_LT(length(colours.at(0, 0) - map_colour(0)), 0.01f);
}

TEST_F(Difference, bad_input_exits_with_2_and_writes_nothing) {
    const auto refused = [&](std::vector<std::string> arguments, const std::string& named) {
        arguments.insert(arguments.begin(), "difference");
        const Call bad = call(arguments);
        EXPECT_EQ(bad.code, 2) << named;
        EXPECT_EQ(bad.out, "");
        EXPECT_NE(bad.err.find(named), std::string::npos) << bad.err;
    };
    const std::string out = file("out.png");
    refused({file("a.exr"), file("turned.exr"), "--out", out}, "3 x 4");
    refused({file("a.exr"), file("none.png"), "--out", out}, "none.png");
    refused({file("a.exr"), file("b.exr"), "--tolerance", "-1", "--out", out}, "--tolerance");
    refused({file("a.exr"), file("b.exr"), "--tolerance", "nan", "--out", out}, "--tolerance");
    refused({file("a.exr"), file("b.exr"), "--out", file("out.gif")}, "out.gif");
    refused({file("a.exr")}, "second");
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace rayshoot
