#include "bench/gallery/gallery.h"

#include "tests/bench/command.h"
#include "tracer/image.h"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace rayshoot::gallery {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The line of the page that renders a picture, as words, without the program's name.
std::vector<std::string> command_in(const std::string& page, const std::string& picture) {
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("rayshoot ") || !line.ends_with(" " + picture + ".png")) continue;
        std::istringstream words(line);
        std::vector<std::string> command{std::istream_iterator<std::string>(words), {}};
        command.erase(command.begin());
        return command;
    }
    return {};
}

TEST(Gallery, page_shows_a_picture_and_the_command_that_makes_its_pixels) {
    const auto folder = fresh_folder("gallery") / "new";
    const Call made = call({"gallery", "--out", folder.string(), "--picture", "matt"});
    ASSERT_EQ(made.code, 0) << made.err;
    const std::string page = text_of(folder / "README.md");
    EXPECT_NE(page.find("](matt.png)"), std::string::npos) << page;

    std::vector<std::string> command = command_in(page, "matt");
    ASSERT_FALSE(command.empty()) << page;
    command.back() = (folder / "again.png").string();
    const Call again = call(command);
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(read_image(folder / "matt.png"), read_image(folder / "again.png"));
}

TEST(Gallery, structure_is_in_the_command_and_changes_no_pixel) {
    const auto folder = fresh_folder("gallery_structure");
    const Easel easel{built_in_catalogue()}, other{built_in_catalogue(), "bvh"};
    const std::vector<std::string> name{"matt"};
    const Exhibit matt = chosen_exhibits(name).front();
    const Hung first = hang(matt, easel, folder);
    const Image image = read_image(folder / "matt.png");
    const Hung second = hang(matt, other, folder);
    EXPECT_EQ(read_image(folder / "matt.png"), image);
    EXPECT_EQ(first.counts, second.counts);
    EXPECT_EQ(first.samples, 16);
    EXPECT_NE(command_for(matt, "bvh").find("--structure bvh "), std::string::npos);
}

TEST(Gallery, names_are_unique_and_an_unknown_one_lists_them) {
    std::set<std::string_view> names;
    for (const Exhibit& exhibit : exhibits()) EXPECT_TRUE(names.insert(exhibit.name).second);
    const Call unknown = call({"gallery", "--out", "x", "--picture", "mat"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_NE(unknown.err.find("matt"), std::string::npos) << unknown.err;
    EXPECT_EQ(call({"gallery"}).code, 2);
    EXPECT_NE(call({"gallery", "--list"}).out.find("wagon_wheel"), std::string::npos);
}

TEST(Gallery, exhibits_of_one_effect_are_neighbours) {
    std::set<std::string_view> closed;
    std::string_view current;
    for (const Exhibit& exhibit : exhibits()) {
        if (exhibit.effect == current) continue;
        closed.insert(current);
        current = exhibit.effect;
        EXPECT_FALSE(closed.contains(current)) << current;
    }
}

}  // namespace
}  // namespace rayshoot::gallery
