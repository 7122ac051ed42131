#include "data/aff.h"

#include "data/scenes.h"
#include "tests/data/messages.h"
#include "tests/data/temporary_folder.h"

#include <cmath>
#include <map>
#include <numbers>

namespace rayshoot {
namespace {

const std::string view =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 32\n";  // seven lines

using Texts = std::map<std::string, std::string>;

AffModel model_of(const std::string& text, const Texts& others = {}) {
    return read_aff_model(text, "main.aff", [&](const std::string& path) {
        const auto found = others.find(path);
        if (found == others.end()) throw std::invalid_argument(path + ": there is no such file");
        return found->second;
    });
}

Scene read(const std::string& text, const Texts& others = {}, const Frame& frame = {}) {
    return aff_scene(model_of(text, others), "main.aff", Precision::standard, frame);
}

const Motion& motion_of(const Scene& scene, std::uint32_t primitive) {
    return scene.geometry.motion(scene.geometry.ref(primitive).motion);
}

const std::string triangle = "m vertices 3\n0 0 0\n1 0 0\n0 1 0\ntriangles 1\n0 1 2\n";

/// Key frames that stand still at one value but for a straight way from time 0 to 10.
std::string straight(const std::string& from, const std::string& to) {
    return "transl 4\n -10 " + from + " 0 0 0\n 0 " + from + " 1 0 0\n 10 " + to + " 1 0 0\n 20 " +
           to + " 0 0 0\n";
}

TEST(Aff, bakes_static_transforms_scale_first_and_shift_last) {
    const Scene scene = read(view +
                             "xs 1 1 1 0 0 1 0 0 0 7 {\n"
                             "xs 2 3 1  0 0 1 90  10 0 0 {\n" +
                             triangle + "}}\n" + "s 0 0 0 1\n");
    const Triangle there = scene.geometry.triangle(0);
    EXPECT_LT(length(there.a - vec3(10, 0, 7)), 1e-6f);
    EXPECT_LT(length(there.b - vec3(10, 2, 7)), 1e-6f);
    EXPECT_LT(length(there.c - vec3(7, 0, 7)), 1e-6f);
    EXPECT_EQ(scene.geometry.sphere(0).centre, vec3(0));
}

TEST(Aff, reads_indexed_meshes_with_normals_and_without_textures) {
    const Scene scene = read(view +
                             "xs 1 2 1 0 0 1 0 0 0 0 {\n"
                             "m vertices 4 0 0 0 1 0 0 1 1 0 0 1 0\nnormals 2 0 0 1 0 1 1\n"
                             "texturecoords 1 wood.ppm 0.5 0.5\n"
                             "triangles 2\n0 1 2  0 0 1  0 0 0\n0 2 3  0 1 1  0 0 0\n}\n");
    EXPECT_EQ(scene.geometry.size(), 2u);
    EXPECT_EQ(scene.geometry.vertices().size(), 4u);  // as many as pairs of a vertex and a normal
    // A normal (0, 1, 1) of a surface stretched to twice its height: (0, 1/2, 1).
    const vec3 slanted = scene.geometry.vertex_normals()[2];
    EXPECT_LT(length(slanted - normalised(vec3(0, 0.5f, 1))), 1e-6f);
    EXPECT_EQ(scene.notes, std::vector<std::string>{"texture wood.ppm"});
}

TEST(Aff, includes_files_relative_to_the_one_that_has_them) {
    const Texts others{{"parts/a.aff", "i 0 colour.aff\ni 1 far.aff\n" + triangle},
                       {"parts/colour.aff", "fm 0 0 0 0.5 0.25 0 0.3 0.3 0.3 20 0 0\n"},
                       {"parts/far.aff", triangle + triangle}};
    const Scene near = read(view + "i 0 parts/a.aff\ni 0 parts/a.aff\n", others);
    EXPECT_EQ(near.geometry.size(), 2u);
    EXPECT_EQ(near.material(0).diffuse, 0.5f);
    EXPECT_EQ(near.material(0).colour, vec3(1, 0.5f, 0));
    EXPECT_FLOAT_EQ(near.material(0).specular, 0.3f);
    EXPECT_EQ(read(view + "d 1\ni 0 parts/a.aff\n", others).geometry.size(), 3u);
}

TEST(Aff, comments_begin_with_either_sign_and_braces_need_no_blanks) {
    const Scene scene =
        read("% AFF\n" + view + "# and NFF\nxs 1 1 1 0 0 1 0 5 0 0{s 0 0 0 1}% end\n");
    EXPECT_EQ(scene.geometry.sphere(0).centre, vec3(5, 0, 0));
}

/// The rest pose is where the shutter opens; at its closing everything is where its matrix says.
TEST(Aff, key_frames_become_one_rigid_motion) {
    const std::string wheel = "xs 3 3 3 0 0 1 30 0 0 1 { s 1 2 0 0.25 }\n";
    const std::string text =
        view + "a 0 10 11\nx car { xs 2 2 2 0 1 0 20 0 1 0 { x wheel {" + wheel +
        "} } s 0 1 0 1 }\n" + "k car {" + straight("0 0 0", "4 0 2") +
        "rot 4 -1 0 1 0 0 0 0 0  0 0 1 0 0 0 0 0  10 0 1 0 90 0 0 0  11 0 1 0 90 0 0 0 }\n" +
        "k wheel { rot 4 -1 1 0 0 0 0 0 0  0 1 0 0 0 0 0 0  10 1 0 0 170 0 0 0  11 1 0 0 170 0 0 0 "
        "}";
    const AffModel model = model_of(text);
    const auto matrix = [&](double time, bool of_wheel) {
        const glm::dmat4 car = model.key_frames.at("car").matrix(time);
        if (!of_wheel) return car;
        return car * std::get<glm::dmat4>(model.transforms[2].own) *
               model.key_frames.at("wheel").matrix(time) *
               std::get<glm::dmat4>(model.transforms[4].own);
    };
    for (const int frame : {0, 4, 9})
        for (const double shutter : {0.25, 1.0}) {
            const Scene scene = aff_scene(model, "main.aff", Precision::standard,
                                          {.number = frame, .of = 0, .shutter = shutter});
            for (const bool of_wheel : {true, false}) {
                const std::uint32_t sphere = of_wheel ? 0 : 1;
                const glm::dvec4 local = of_wheel ? glm::dvec4(1, 2, 0, 1) : glm::dvec4(0, 1, 0, 1);
                const dvec3 rest(scene.geometry.sphere(sphere).centre);
                const dvec3 open(matrix(frame, of_wheel) * local);
                const dvec3 close(matrix(frame + shutter, of_wheel) * local);
                EXPECT_LT(length(rest - open), 2e-6);
                EXPECT_LT(length(move_to_world(motion_of(scene, sphere), 0, rest) - open), 4e-6);
                EXPECT_LT(length(move_to_world(motion_of(scene, sphere), 1, rest) - close), 4e-6);
                EXPECT_GT(length(close - open), 1e-3);
            }
            EXPECT_FLOAT_EQ(scene.geometry.sphere(0).radius, 1.5f);
        }
}

TEST(Aff, what_stands_still_in_an_exposure_has_no_motion) {
    const std::string text =
        view + "a -10 20 4\nx car { s 0 0 0 1 }\nk car {" + straight("0 0 0", "4 0 0") + "}\n";
    const auto motion = [&](int frame) {
        return read(text, {}, {.number = frame}).geometry.ref(0).motion;
    };
    EXPECT_EQ(motion(0), no_motion);
    EXPECT_NE(motion(1), no_motion);
    EXPECT_EQ(motion(2), no_motion);
    EXPECT_EQ(read(text, {}, {.number = 2}).geometry.sphere(0).centre, vec3(4, 0, 0));
}

TEST(Aff, things_are_seen_when_their_key_frames_say_so) {
    const std::string text = view +
                             "a 0 10 11\nx ghost { s 0 0 0 1 x car { s 1 0 0 1 } }\ns 5 5 5 1\n"
                             "k ghost { visibility 2 2.9 0 6.1 1 }\nk car {" +
                             straight("0 0 0", "1 0 0") + "}\n";
    EXPECT_EQ(read(text, {}, {.number = 2}).geometry.size(), 3u);
    EXPECT_EQ(read(text, {}, {.number = 4}).geometry.size(), 1u);
    EXPECT_EQ(read(text, {}, {.number = 6}).geometry.size(), 3u);
}

TEST(Aff, the_camera_follows_its_key_frames) {
    const std::string text =
        view + "a 0 10 11\ns 0 0 0 1\nk camera {" + straight("0 0 5", "10 0 5") +
        "rot 4 -10 0 1 0 0 0 0 0  0 0 1 0 0 1 0 0  10 0 1 0 90 1 0 0  20 0 1 0 90 0 0 0 }\n";
    const Scene scene = read(text, {}, {.number = 5, .of = 0, .shutter = 1});
    const double half = 1 / std::numbers::sqrt2;
    EXPECT_LT(length(scene.camera.from - vec3(5, 0, 5)), 1e-5f);
    const vec3 gaze = normalised(scene.camera.at - scene.camera.from);
    EXPECT_LT(length(dvec3(gaze) - dvec3(-half, 0, -half)), 1e-6);
    ASSERT_TRUE(scene.camera.motion);
    // Tension 1 at both ends: 3 u^2 - 2 u^3 of the way at the share u of the time.
    const double share = 3 * 0.36 - 2 * 0.216, angle = share * std::numbers::pi / 2;
    const dvec3 from = move_to_world(*scene.camera.motion, 1, dvec3(scene.camera.from));
    EXPECT_LT(length(from - dvec3(10 * share, 0, 5)), 2e-6);
    const dvec3 later = dvec3(rotate_to_world(*scene.camera.motion, 1, gaze));
    EXPECT_LT(length(later - dvec3(-std::sin(angle), 0, -std::cos(angle))), 2e-6);
}

TEST(Aff, frames_divide_the_time_that_the_file_gives) {
    const std::string text = view +
                             "a 0 10 5\nx car { s 0 0 0 1 }\nk car { transl 4 -10 -10 0 0 0 0 0 "
                             "0 0 0 0 0 0 0 10 10 0 0 0 0 0 20 20 0 0 0 0 0 }\n";
    const auto x = [&](const Frame& frame) {
        return read(text, {}, frame).geometry.sphere(0).centre.x;
    };
    EXPECT_FLOAT_EQ(x({.number = 1}), 2.5f);
    EXPECT_FLOAT_EQ(x({.number = 4}), 10);
    EXPECT_FLOAT_EQ(x({.number = 1, .of = 3}), 5);
    EXPECT_FLOAT_EQ(motion_of(read(text, {}, {.number = 1}), 0).translation[1].x, 1.25f);
    EXPECT_TRUE(contains(message_of([&] { x({.number = 5}); }), "the animation has 5 frames"));
}

TEST(Aff, lights_share_their_light_as_those_of_nff_and_may_move) {
    const Scene scene = read(view +
                             "l 1 2 3 0.5 0.25 0.125\nla lamp 9 9 9\nl 0 0 0\nl 0 0 0\n"
                             "k lamp {" +
                             straight("1 0 0", "3 0 0") + "}\na 5 5 1\n");
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.lights[0].intensity, vec3(0.5f, 0.25f, 0.125f));
    EXPECT_EQ(scene.lights[2].intensity, vec3(0.5f));
    EXPECT_LT(length(scene.lights[1].position - vec3(2, 0, 0)), 1e-6f);
}

TEST(Aff, deformed_triangles_are_taken_in_the_middle_of_the_exposure) {
    const auto at = [](const std::string& time, const std::string& z) {
        const std::string corner = " 0 0 1\n";
        return time + " 0 0 " + z + corner + "1 0 " + z + corner + "0 1 " + z + corner;
    };
    const std::string text = view + "a 0 4 5\ntpa 2 " + at("1", "0") + at("3", "8");
    const auto z = [&](int frame) {
        return read(text, {}, {.number = frame}).geometry.triangle(0).a.z;
    };
    EXPECT_FLOAT_EQ(z(0), 0);
    EXPECT_FLOAT_EQ(z(1), 1);  // time 1.25
    EXPECT_FLOAT_EQ(z(4), 8);
}

TEST(Aff, is_loaded_from_files_frame_by_frame) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.aff", view + "a 0 10 11\ni 0 sub/car.aff\nk car {" + straight("0 0 0", "4 0 0") + "}\n");
    folder.write("sub/car.aff", "x car { tt wood.ppm 0 0 0 0 0 1 0 0 0 0 0 1 0 0 0 }\n");
    EXPECT_EQ(load_scene(file).geometry.triangle(0).a, vec3(0));
    EXPECT_FLOAT_EQ(load_scene(file + ":frame=5").geometry.triangle(0).a.x, 2);
    EXPECT_FLOAT_EQ(load_frame(file, 1, 3).geometry.triangle(0).a.x, 2);
    EXPECT_EQ(load_scene(file + ":frame=5,shutter=0").geometry.ref(0).motion, no_motion);
    std::filesystem::remove(folder.path() / "sub/car.aff");
    const std::string message = message_of([&] { load_scene(file); });
    EXPECT_TRUE(contains(message, "a.aff:9: "));
    EXPECT_TRUE(contains(message, "there is no such file"));
}

struct Malformed {
    std::string text;
    std::string where, what;
};

std::ostream& operator<<(std::ostream& out, const Malformed& malformed) {
    return out << malformed.what;
}

class MalformedAff : public testing::TestWithParam<Malformed> {};

const Texts bad_includes{{"self.aff", "i 0 self.aff\n"},
                         {"to.aff", "i 0 fro.aff\n"},
                         {"fro.aff", "\ni 0 to.aff\n"},
                         {"open.aff", "xs 1 1 1 0 0 1 0 0 0 0 {\n"},
                         {"close.aff", "}\n"}};

TEST_P(MalformedAff, is_refused_with_line_and_remedy) {
    const std::string message = message_of([] { read(GetParam().text, bad_includes); });
    EXPECT_TRUE(contains(message, GetParam().where + ": "));
    EXPECT_TRUE(contains(message, GetParam().what));
}

const std::string keys4 = "transl 4 0 0 0 0 0 0 0  1 0 0 0 0 0 0  2 0 0 0 0 0 0  3 0 0 0 0 0 0";

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedAff,
    testing::Values(
        Malformed{"s 0 0 0 1\n", "main.aff", "there is no view"},
        Malformed{view + "q 1\n", "main.aff:8", "unknown entity 'q'; AFF has v, b, l"},
        Malformed{view + "s 0 0 0 1 2\n", "main.aff:8", "a number too many"},
        Malformed{view + "i 0 self.aff\n", "self.aff:1", "'self.aff' includes itself"},
        Malformed{view + "i 0 main.aff\n", "main.aff:8", "'main.aff' includes itself"},
        Malformed{view + "i 0 to.aff\n", "fro.aff:2", "'to.aff' includes itself"},
        Malformed{view + "i 0 none.aff\n", "main.aff:8", "there is no such file"},
        Malformed{view + "i 0 /etc/hosts\n", "main.aff:8", "relative"},
        Malformed{view + "i 0 open.aff\n}\n", "open.aff:2", "close it by }"},
        Malformed{view + "xs 1 1 1 0 0 1 0 0 0 0 {\ni 0 close.aff\n", "close.aff:1",
                  "without a transform"},
        Malformed{view + "i x y.aff\n", "main.aff:8", "'x' stands where a number"},
        Malformed{view + "}\n", "main.aff:8", "without a transform"},
        Malformed{view + "xs 1 1 1 0 0 1 0 0 0 0 {\n", "main.aff:9", "close it by }"},
        Malformed{view + "xs 1 1 1 0 0 1 0 0 0 0 s\n", "main.aff:8", "'s' where { is expected"},
        Malformed{view + "xs 1 1 1 0 0 0 90 0 0 0 {}\n", "main.aff:8", "axis of this rotation"},
        Malformed{view + "\nx ghost { s 0 0 0 1 }\n", "main.aff:9", "no key frames `k ghost`"},
        Malformed{view + "xs 1 2 1 0 0 1 0 0 0 0 {\ns 0 0 0 1 }\n", "main.aff:9",
                  "cannot be scaled unevenly"},
        Malformed{view + "xs 9e37 9e37 9e37 0 0 1 0 0 0 0 {\ns 9 0 0 1 }\n", "main.aff:9",
                  "must be finite"},
        Malformed{view + "k a { transl 3 0 0 0 0 0 0 0 }\n", "main.aff:8", "out of range"},
        Malformed{view + "k a { " + keys4 + " " + keys4 + " }\n", "main.aff:8", "second 'transl'"},
        Malformed{view + "k a { spin 4 }\n", "main.aff:8", "'spin' in key frames"},
        Malformed{view + "k a { " + keys4 + "\n", "main.aff:9", "'' in key frames"},
        Malformed{view + "k a { " + keys4 + " } k a { " + keys4 + " }\n", "main.aff:8",
                  "a second set of key frames for 'a'"},
        Malformed{view + "k a { transl 4 0 0 0 0 0 0 0  1 0 0 0 0 0 0  0.5 0 0 0 0 0 0\n",
                  "main.aff:8", "order of time"},
        Malformed{view + "k a { visibility 1 0 2 }\n", "main.aff:8", "out of range"},
        Malformed{view + "m vertices 3 0 0 0 1 0 0 0 1 0 triangles 1 0 1 3\n", "main.aff:8",
                  "3 is out of range"},
        Malformed{view + "m vertices 2000000000 0 0 0\n", "main.aff:8", "out of range"},
        Malformed{view + "m faces 3\n", "main.aff:8", "'faces' in a mesh"},
        Malformed{view + "m vertices 0 triangles 1 0 0 0\n", "main.aff:8", "out of range"},
        Malformed{view + "fm 0 0 0 -1 0 0 0 0 0 1 0 0\n", "main.aff:8", "negative"},
        Malformed{view + "a 5 1 10\n", "main.aff:8", "ends before it begins"},
        Malformed{view + "a 0 1 0\n", "main.aff:8", "out of range"},
        Malformed{view + "tpa 2 1 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1 "
                         "1 0 0 0 0 0 1 1 0 0 0 0 1 0 1 0 0 0 1\n",
                  "main.aff:8", "must ascend"}));

TEST(Aff, that_flattens_what_moves_is_refused) {
    const std::string text = view +
                             "x flat {\ns 0 0 0 1 }\nk flat { scale 4 0 0 0 0 0 0 0  1 0 0 0 0 "
                             "0 0  2 1 1 1 0 0 0  3 1 1 1 0 0 0 }\na 1 2 2\n";
    EXPECT_TRUE(contains(message_of([&] { read(text); }), "main.aff:9: what the key frames move"));
}

}  // namespace
}  // namespace rayshoot
