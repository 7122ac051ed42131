#include "bench/textbook/textbook.h"

#include "bench/textbook/filtered.h"
#include "bench/textbook/pictures.h"
#include "bench/textbook/shots.h"
#include "tests/bench/command.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <set>

namespace rayshoot::textbook {
namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The whole command once, small, for all tests below.
class Textbook : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder() = fresh_folder("textbook") / "new";
        made() = call({"textbook", "--out", folder().string(), "--size", "64", "--json"});
    }
    static std::filesystem::path& folder() {
        static std::filesystem::path path;
        return path;
    }
    static Call& made() {
        static Call call;
        return call;
    }
};

TEST_F(Textbook, every_check_of_every_figure_holds) {
    ASSERT_EQ(made().code, 0) << made().out << made().err;
    const Json document = made().json();
    ASSERT_EQ(document["figures"].size(), figures().size());
    for (const Json& figure : document["figures"]) {
        EXPECT_FALSE(figure["checks"].empty()) << figure["figure"];
        for (const Json& check : figure["checks"])
            EXPECT_NE(check["verdict"], "OFF") << figure["figure"] << check.dump();
    }
}

TEST_F(Textbook, flags_the_two_known_misprints_and_no_other) {
    std::set<std::string> misprints;
    const Json document = made().json();
    for (const Json& figure : document["figures"]) {
        for (const Json& check : figure["checks"]) {
            if (check["verdict"] == "misprint") misprints.insert(check["claim"]);
        }
    }
    EXPECT_EQ(misprints,
              (std::set<std::string>{"raised cosine, 2.0: integral", "cone, 1.5: least sum"}));
}

TEST_F(Textbook, page_links_what_is_there_and_shows_every_check) {
    const std::string page = text_of(folder() / "README.md");
    const Json document = made().json();
    for (const Json& figure : document["figures"]) {
        EXPECT_NE(page.find("## " + figure["figure"].get<std::string>() + "\n"), std::string::npos);
        for (const Json& picture : figure["pictures"]) {
            const std::string file = picture.get<std::string>() + ".png";
            EXPECT_NE(page.find("](" + file + ")"), std::string::npos) << file;
            EXPECT_GT(read_image(folder() / file).width(), 0);
        }
        for (const Json& check : figure["checks"])
            EXPECT_NE(page.find(check["claim"].get<std::string>()), std::string::npos);
    }
    std::size_t charts = 0;
    const Json drawn = Json::parse(text_of(folder() / "charts.json"));
    for (const Json& chart : drawn["charts"]) {
        const std::string csv = text_of(folder() / (chart["name"].get<std::string>() + ".csv"));
        EXPECT_TRUE(csv.starts_with("series,mark,x,y\r\n")) << chart;
        ++charts;
    }
    EXPECT_GT(charts, 4u);
}

TEST(TextbookCommand, makes_one_figure_and_prints_its_checks) {
    const auto folder = fresh_folder("textbook_one");
    const Call made = call({"textbook", "--out", folder.string(), "--figure", "aliases"});
    ASSERT_EQ(made.code, 0) << made.err;
    EXPECT_NE(made.out.find("published"), std::string::npos);
    EXPECT_NE(made.out.find("3 checks: 0 failed"), std::string::npos) << made.out;
    EXPECT_TRUE(std::filesystem::exists(folder / "aliases.csv"));
    EXPECT_FALSE(std::filesystem::exists(folder / "moire.png"));
}

TEST(TextbookCommand, lists_its_figures_without_making_any) {
    const Call listed = call({"textbook", "--list"});
    EXPECT_EQ(listed.code, 0);
    for (const Figure& figure : figures())
        EXPECT_NE(listed.out.find(figure.name), std::string::npos) << figure.name;
}

TEST(TextbookCommand, bad_input_exits_with_2) {
    const std::string out = (fresh_folder("textbook_bad") / "figures").string();
    const auto refused = [&](std::vector<std::string> arguments, const std::string& named) {
        arguments.insert(arguments.begin(), "textbook");
        const Call bad = call(arguments);
        EXPECT_EQ(bad.code, 2) << named;
        EXPECT_NE(bad.err.find(named), std::string::npos) << bad.err;
    };
    refused({}, "--out");
    refused({"--out", out, "--figure", "frontispiece"}, "frontispiece");
    refused({"--out", out, "--size", "8"}, "--size");
    refused({"--out", out, "--size", "100000"}, "--size");
    refused({"--out", out, "--threads", "0"}, "threads");
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Figures, that_fail_a_check_fail_the_command) {
    Sheet sheet(fresh_folder("sheet"));
    sheet.add(Check{"one", "1", "1", Verdict::agrees});
    sheet.add(Check{"two", "2.74", "3.74", Verdict::misprint});
    EXPECT_TRUE(sheet.holds());
    sheet.add(Check{"three", "3", "4", agrees_if(3 == 4)});
    EXPECT_FALSE(sheet.holds());
    std::vector<FinishedFigure> finished{{{"mine", "what it shows", nullptr}, sheet}};
    EXPECT_FALSE(all_hold(finished));
    EXPECT_EQ(check_table(finished).rows.back().back(), "OFF");
}

/// The box's transform is the product of two sinc's, in closed form.
TEST(Response, of_the_box_is_sinc) {
    const Filter box;
    for (const auto& [x, y] : {std::pair(0.3, 0.0), std::pair(0.5, 0.9), std::pair(1.2, 0.1)}) {
        const auto sinc = [](double f) {
            const double t = std::numbers::pi * f;
            return t == 0 ? 1 : std::sin(t) / t;
        };
        EXPECT_NEAR(response(box, x, y), sinc(x) * sinc(y), 1e-5);
    }
}

/// The Hankel transform of a cut Gaussian tends to exp(-2 (pi sigma f)^2); of what is cut off at
/// 3 sigma, exp(-4.5), a part comes back.
TEST(Response, of_the_gaussian_is_nearly_a_gaussian) {
    constexpr double radius = 1.5, sigma = radius / 3;
    const Filter gaussian({FilterKind::gaussian, radius});
    for (const double f : {0.0, 0.2, 0.5, 0.8}) {
        const double t = std::numbers::pi * sigma * f;
        EXPECT_NEAR(response(gaussian, f * 0.6, f * 0.8), std::exp(-2 * t * t), 2 * std::exp(-4.5));
    }
    EXPECT_NEAR(response(gaussian, 0, 0), 1, 1e-12);
}

TEST(Filtered, keeps_a_constant_and_multiplies_a_wave_by_the_response) {
    const Filter hann({FilterKind::raised_cosine, 1.7});
    const ScalarImage flat = filtered([](double, double) { return 3.0; }, hann, 5, 4, 8);
    for (const double value : flat.values()) EXPECT_NEAR(value, 3, 1e-12);
    const double along_x = 0.3, along_y = 0.2;
    const Signal wave = [&](double x, double y) {
        return std::cos(2 * std::numbers::pi * (along_x * x + along_y * y));
    };
    const ScalarImage plain = point_sampled(wave, 6, 5);
    const ScalarImage image = filtered(wave, hann, 6, 5, 16);
    const double factor = response(hann, along_x, along_y);
    for (std::size_t i = 0; i < plain.values().size(); ++i)
        EXPECT_NEAR(image.values()[i], factor * plain.values()[i], 2e-4);
}

TEST(Pictures, are_cut_enlarged_and_laid_side_by_side) {
    Image image(3, 2);
    image.at(2, 1) = vec3(1, 0, 0);
    const Image part = cropped(image, 1, 0, 2, 2);
    EXPECT_EQ(part.at(1, 1), vec3(1, 0, 0));
    const Image large = magnified(part, 3);
    EXPECT_EQ(large.width(), 6);
    EXPECT_EQ(large.at(3, 3), vec3(1, 0, 0));
    EXPECT_EQ(large.at(2, 3), vec3(0));
    const Image rows = tiled(std::vector<Image>{image, image, image}, 2);
    EXPECT_EQ(rows.width(), 3 + 4 + 3);
    EXPECT_EQ(rows.height(), 2 + 4 + 2);
    EXPECT_EQ(rows.at(2, 1), vec3(1, 0, 0));
    EXPECT_EQ(rows.at(3, 0), vec3(1));
    EXPECT_EQ(rows.at(9, 1), vec3(1, 0, 0));
    EXPECT_EQ(rows.at(2, 7), vec3(1, 0, 0));
    EXPECT_EQ(rows.at(9, 7), vec3(1)) << "no fourth picture";
}

TEST(Profile, crosses_a_level_between_its_points) {
    const Profile ramp{{0, 0}, {1, 0}, {3, 1}, {4, 1}};
    EXPECT_DOUBLE_EQ(crossing(ramp, 0.25), 1.5);
    EXPECT_DOUBLE_EQ(tenth_to_ninth_width(ramp), 1.6);
    const Profile falling{{0, 1}, {3, 0}};
    EXPECT_DOUBLE_EQ(tenth_to_ninth_width(falling), 2.4);
    EXPECT_THROW(crossing(ramp, 2), std::runtime_error);
}

TEST(Profile, departs_from_a_curve_by_its_farthest_point) {
    const Profile points{{0, 0}, {1, 1.25}, {2, 1.5}};
    const auto line = [](double x) { return x; };
    EXPECT_DOUBLE_EQ(largest_departure(points, line), 0.5);
    EXPECT_EQ(at_places_of(points, line), (Profile{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(Verdicts, allow_a_share_on_either_side) {
    EXPECT_EQ(agrees_within(1.01, 1, 0.02), Verdict::agrees);
    EXPECT_EQ(agrees_within(-0.97, -1, 0.02), Verdict::off);
    EXPECT_EQ(agrees_within(-2.5, 2.5, 0.02), Verdict::off);
}

}  // namespace
}  // namespace rayshoot::textbook
