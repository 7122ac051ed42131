#include "data/nff.h"

#include "tests/data/messages.h"

namespace rayshoot {
namespace {

const std::string view =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 32\n";  // seven lines

Scene read(const std::string& text) { return read_nff(text, "test.nff"); }

TEST(Nff, reads_every_entity) {
    const Scene scene = read("b 0.1 0.2 0.3 # sky\n" + view +
                             "l 1 2 3 0.5 0.25 0.125\nf 1 0.5 0 0.7 0.3 20 0.1 1.5\n"
                             "s 1 2 3 4\nc 0 0 0 2 0 0 1 1\nc\n0 0 0 1\n0 0 2 1\n"
                             "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                             "pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n");
    const auto counts = scene.geometry.count_by_kind();
    EXPECT_EQ(counts[static_cast<int>(PrimitiveKind::triangle)], 1u);
    EXPECT_EQ(counts[static_cast<int>(PrimitiveKind::sphere)], 1u);
    EXPECT_EQ(counts[static_cast<int>(PrimitiveKind::frustum)], 2u);
    EXPECT_EQ(counts[static_cast<int>(PrimitiveKind::polygon)], 1u);
    EXPECT_EQ(scene.background, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(scene.camera.from, vec3(0, 0, 5));
    EXPECT_EQ(scene.camera.width, 64);
    EXPECT_EQ(scene.camera.height, 32);
    EXPECT_EQ(scene.lights.at(0).intensity, vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(scene.material(3).refraction_index, 1.5f);
    EXPECT_EQ(scene.geometry.frustum(0).base_radius, 2);
    EXPECT_EQ(scene.geometry.frustum(1).apex, vec3(0, 0, 2));
}

TEST(Nff, is_read_by_words_whatever_the_lines_are) {
    std::string one_line = view + "s 1 2 3 4 c 0 0 0 2 0 0 1 1 p 3 0 0 0 1 0 0 1 1 0";
    std::string many_lines = one_line;
    for (char& c : one_line) c = c == '\n' ? '\t' : c;
    for (char& c : many_lines) c = c == ' ' ? '\n' : c;
    EXPECT_EQ(digest(read(one_line)), digest(read(many_lines)));
}

TEST(Nff, keeps_the_order_of_the_file_and_the_material_in_force) {
    const Scene scene = read(view +
                             "s 0 0 0 1\nf 1 0 0 1 0 1 0 1\ns 0 0 0 2\np 3 0 0 0 1 0 0 0 1 0\n"
                             "f 0 1 0 1 0 1 0 1\ns 0 0 0 3\n");
    EXPECT_EQ(scene.geometry.ref(2).kind, PrimitiveKind::triangle);
    EXPECT_EQ(scene.material(0).colour, vec3(1));
    EXPECT_EQ(scene.material(1).colour, vec3(1, 0, 0));
    EXPECT_EQ(scene.material(2).colour, vec3(1, 0, 0));
    EXPECT_EQ(scene.material(3).colour, vec3(0, 1, 0));
}

TEST(Nff, shares_the_light_out_where_the_file_gives_no_colour) {
    const Scene scene = read(view + "l 0 0 0\nl 1 1 1\nl 2 2 2 1 0 0\nl 3 3 3\n");
    EXPECT_EQ(scene.lights.at(0).intensity, vec3(0.5f));
    EXPECT_EQ(scene.lights.at(3).intensity, vec3(0.5f));
    EXPECT_EQ(scene.lights.at(2).intensity, vec3(1, 0, 0));
}

TEST(Nff, takes_negative_radii_as_their_size) {
    const Scene scene = read(view + "s 0 0 0 -2\nc 0 0 0 -2 0 0 1 -1\n");
    EXPECT_EQ(scene.geometry.sphere(0).radius, 2);
    EXPECT_EQ(scene.geometry.frustum(0).base_radius, 2);
    EXPECT_EQ(scene.geometry.frustum(0).apex_radius, 1);
}

TEST(Nff, keeps_degenerate_polygons) {
    EXPECT_EQ(read(view + "p 3 0 0 0 1 0 0 2 0 0\np 4 1 1 1 1 1 1 1 1 1 1 1 1\n").geometry.size(),
              2u);
}

TEST(Nff, reads_numbers_in_any_writing) {
    const Scene scene = read(view + "s +1 -.5 1e-50 1.E2\ns 1E+2 0 -0 1e-46\n");
    EXPECT_EQ(scene.geometry.sphere(0).centre, vec3(1, -0.5f, 0));
    EXPECT_EQ(scene.geometry.sphere(0).radius, 100);
    EXPECT_EQ(scene.geometry.sphere(1).radius, 0);
}

struct Malformed {
    std::string text;
    std::string where, what;
};

std::ostream& operator<<(std::ostream& out, const Malformed& malformed) {
    return out << malformed.what;
}

class MalformedNff : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedNff, is_refused_with_line_and_remedy) {
    const std::string message = message_of([] { read(GetParam().text); });
    EXPECT_TRUE(contains(message, "test.nff:" + GetParam().where + ": "));
    EXPECT_TRUE(contains(message, GetParam().what));
}

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedNff,
    testing::Values(
        Malformed{"", "1", "there is no view"}, Malformed{"s 0 0 0 1\n", "2", "there is no view"},
        Malformed{view + "s 0 zero 0 1\n", "8", "'zero' stands where a number is expected"},
        Malformed{view + "s 0 0 0\n", "9", "the file ends where a number is expected"},
        Malformed{view + "s 0 0 0 1 2\n", "8", "a number too many"},
        Malformed{view + "s 0 0 0 1e39\n", "8", "'1e39'"},
        Malformed{view + "s nan 0 0 1\n", "8", "'nan'"},
        Malformed{view + "s 0 0 inf 1\n", "8", "'inf'"},
        Malformed{view + "q 1 2 3\n", "8", "unknown entity 'q'; NFF has v, b, l, f, s, c, p, pp"},
        Malformed{view + "p 2\n0 0 0\n1 1 1\n", "8", "out of range"},
        Malformed{view + "p 2000000000\n0 0 0\n", "8", "out of range"},
        Malformed{view + "p -3\n", "8", "out of range"}, Malformed{view + "p 3.5\n", "8", "'3.5'"},
        Malformed{view + "p 3\n0 0 0\n1 0 0\n", "11", "the file ends"},
        Malformed{view + "p 3\n0 0 0\n1 0 0\ns 0 0 0 1\n", "11", "'s' stands where a number"},
        Malformed{view + "c 0 0 0 1 0 0 1 -1\n", "8", "one radius of this cone is negative"},
        Malformed{view + "l 1 2\n", "9", "light: l x y z"},
        Malformed{view + "l 1 2 3 4\nf 1 1 1 1 1 1 1 1\n", "9", "colour of a light"},
        Malformed{view + "f 1 1 1 1 -1 1 1 1\n", "8", "negative"},
        Malformed{view + "f 1 1 1 1\n", "9", "surface: f red green blue"},
        Malformed{view + view, "8", "a second view"},
        Malformed{"v\nfrom 0 0 5\nfrom 0 0 6\n", "3", "'from' in a view"},
        Malformed{"v\nfrom 0 0 5\nto 0 0 6\n", "3", "'to' in a view"},
        Malformed{"v from 0 0 5 at 0 0 5 up 0 1 0 angle 45 hither 1 resolution 4 4", "1",
                  "no direction"},
        Malformed{"v from 0 0 5 at 0 0 0 up 0 0 1 angle 45 hither 1 resolution 4 4", "1",
                  "no direction"},
        Malformed{"v from 0 0 5 at 0 0 0 up 0 1 0 angle 180", "1", "between 0 and 180"},
        Malformed{"v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 0 4", "1",
                  "resolution in x"},
        Malformed{"v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 4 99999999", "1",
                  "resolution in y"},
        Malformed{std::string(100000, 'x'), "1", "unknown entity 'xxx"},
        Malformed{std::string("\0\1\2\3 \xff", 6), "1", "unknown entity"}));

}  // namespace
}  // namespace rayshoot
