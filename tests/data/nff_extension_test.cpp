#include "data/file.h"
#include "data/mesh_catalogue.h"
#include "data/nff.h"
#include "data/scenes.h"

#include "tests/data/messages.h"
#include "tests/data/temporary_folder.h"

#include <cmath>
#include <numbers>

namespace rayshoot {
namespace {

const std::string view =
    "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 32\n";  // seven lines

Scene read(const std::string& text, const Frame& frame = {}) {
    return read_nff(text, "test.nff", Precision::standard, frame);
}

const Motion& motion_of(const Scene& scene, std::uint32_t primitive) {
    return scene.geometry.motion(scene.geometry.ref(primitive).motion);
}

bool still(const Scene& scene, std::uint32_t primitive) {
    return scene.geometry.ref(primitive).motion == no_motion;
}

TEST(NffExtension, moves_what_follows_until_rest) {
    const Scene scene = read(view +
                             "s 0 0 0 1\nmove 0 0 0 2 0 0\ns 0 0 0 1\np 3 0 0 0 1 0 0 0 1 0\n"
                             "rest\ns 1 1 1 1\nmove 1 0 0 0 0 0 s 0 0 0 1\n");
    EXPECT_TRUE(still(scene, 0));
    EXPECT_EQ(motion_of(scene, 1).translation[1], vec3(2, 0, 0));
    EXPECT_EQ(scene.geometry.ref(1).motion, scene.geometry.ref(2).motion);
    EXPECT_TRUE(still(scene, 3));
    EXPECT_EQ(motion_of(scene, 4).translation[0], vec3(1, 0, 0));
}

/// By the sine and cosine of the definition.
TEST(NffExtension, turns_about_an_axis_through_a_point_before_it_shifts) {
    const Scene scene = read(view + "turn 1 0 0 0 0 2 10 70\nmove 0 0 3 0 0 5\ns 2 0 0 0.1\n");
    const Motion& motion = motion_of(scene, 0);
    for (const int end : {0, 1}) {
        const double angle = (end == 0 ? 10 : 70) * std::numbers::pi / 180;
        const dvec3 wanted(1 + std::cos(angle), std::sin(angle), end == 0 ? 3 : 5);
        const dvec3 there = move_to_world(motion, static_cast<float>(end), dvec3(2, 0, 0));
        EXPECT_LT(length(there - wanted), 1e-6);
    }
}

TEST(NffExtension, a_frame_has_its_share_of_the_motion_for_as_long_as_the_shutter_is_open) {
    const std::string text = view +
                             "shutter 0.25 0.75\nmove 0 0 0 8 0 0\ns 0 0 0 1\n"
                             "vmove 0 0 0 0 16 0\nvturn 0 0 0 0 1 0 0 720\n";
    const auto shift = [](const Scene& scene) { return motion_of(scene, 0).translation; };
    const Scene third = read(text, {.number = 2, .of = 4});
    EXPECT_EQ(shift(third)[0].x, 4.5f);  // 8 (2 + 0.25) / 4
    EXPECT_EQ(shift(third)[1].x, 5.5f);
    EXPECT_EQ(third.camera.motion->translation[0].y, 9.0f);
    const Scene instant = read(text, {.number = 2, .of = 4, .shutter = 0});
    EXPECT_EQ(shift(instant)[0], shift(instant)[1]);
    const Scene longer = read(text, {.number = 0, .of = 16, .shutter = 1});
    EXPECT_EQ(shift(longer)[1].x, 8 * 1.25f / 16);
}

TEST(NffExtension, a_wheel_turns_many_times_in_an_animation_but_little_in_a_frame) {
    const std::string text = view + "turn 0 0 0 0 0 1 0 7200\ns 1 0 0 0.1\n";
    EXPECT_TRUE(contains(message_of([&] { read(text); }), "test.nff:9: a turn by 7200"));
    for (const int frame : {0, 17, 79}) {
        const Scene scene = read(text, {.number = frame, .of = 80});
        const double angle = (frame + 1) * std::numbers::pi / 2;
        const dvec3 there = move_to_world(motion_of(scene, 0), 1, dvec3(1, 0, 0));
        EXPECT_LT(length(there - dvec3(std::cos(angle), std::sin(angle), 0)), 1e-6);
    }
}

TEST(NffExtension, frames_of_a_still_file_are_all_the_same) {
    const std::string text = view + "l 1 2 3\nf 1 1 1 1 0 1 0 1\ns 0 0 0 1\n";
    EXPECT_EQ(digest(read(text)), digest(read(text, {.number = 3, .of = 9, .shutter = 0.5})));
}

TEST(NffExtension, gives_the_camera_a_lens) {
    const Scene scene = read(view + "lens focus 5 focal 0.5 stop 2.8 angle 15 blades 6\n");
    EXPECT_EQ(*scene.camera.lens, (Lens{0.5f, 2.8f, 5, 6, 15}));
    EXPECT_FALSE(read(view).camera.lens);
}

TEST(NffExtension, reads_lights_of_every_kind) {
    const Scene scene = read(view +
                             "light point 1 2 3 4 5 6\n"
                             "light directional 0 -2 0 1 1 1\n"
                             "light spot 0 0 0 0 0 -3 20 30 9 9 9\n"
                             "light rectangle 0 2 0 1 0 0 0 0 2 7 7 7 strata 4 8\n"
                             "light disc 0 3 0 0 -1 0 0.5 1 2 3\n"
                             "light sphere 5 5 5 2 1 1 1\n");
    ASSERT_EQ(scene.lights.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(static_cast<std::size_t>(scene.lights[i].kind), i);  // in the order of LightKind
        EXPECT_EQ(scene.lights[i].falloff, Falloff::inverse_square);
        EXPECT_TRUE(scene.lights[i].primitives.empty());
    }
    EXPECT_EQ(scene.lights[0].intensity, vec3(4, 5, 6));
    EXPECT_EQ(scene.lights[1].direction, vec3(0, -1, 0));
    EXPECT_TRUE(scene.lights[1].samples.empty());
    EXPECT_FLOAT_EQ(scene.lights[2].cos_inner, std::cos(20 * std::numbers::pi_v<float> / 180));
    EXPECT_FLOAT_EQ(scene.lights[2].cos_outer, std::cos(30 * std::numbers::pi_v<float> / 180));
    EXPECT_EQ(scene.lights[3].edge_v, vec3(0, 0, 2));
    EXPECT_EQ(scene.lights[3].strata_v, 8);
    EXPECT_EQ(scene.lights[3].samples, (Box{vec3(0, 2, 0), vec3(1, 2, 2)}));
    EXPECT_EQ(scene.lights[4].samples, (Box{vec3(-0.5f, 3, -0.5f), vec3(0.5f, 3, 0.5f)}));
    EXPECT_EQ(scene.lights[5].samples, (Box{vec3(3), vec3(7)}));
}

TEST(NffExtension, visible_lights_are_geometry_that_reflects_nothing) {
    const Scene scene = read(view +
                             "f 0.5 0.5 0.5 1 0 1 0 1\n"
                             "light rectangle 0 2 0 1 0 0 0 0 2 7 7 7 visible\n"
                             "s 0 0 0 1\nlight sphere 5 5 5 2 1 2 3 visible\n");
    ASSERT_EQ(scene.lights.size(), 2u);
    EXPECT_EQ(scene.lights[0].primitives, std::vector<std::uint32_t>{0});
    EXPECT_EQ(scene.lights[1].primitives, std::vector<std::uint32_t>{2});
    EXPECT_EQ(scene.geometry.ref(0).kind, PrimitiveKind::polygon);
    EXPECT_EQ(scene.geometry.sphere(1).radius, 2);
    EXPECT_EQ(scene.material(0).diffuse, 0);
    EXPECT_EQ(scene.material(0).emission, vec3(7));
    EXPECT_EQ(scene.material(1).colour, vec3(0.5f));  // the surface in force is not disturbed
    // The light shines to the side of its normal: u x v.
    const Normals normals = scene.geometry.normal({}, {.t = 1, .primitive = 0});
    EXPECT_EQ(normals.geometric, vec3(0, -1, 0));
}

TEST(NffExtension, surfaces_that_emit_are_lights) {
    const Scene scene = read(view +
                             "surface lambert colour 0 0 0 emission 3 2 1\n"
                             "p 3 0 0 0 1 0 0 0 1 0\np 3 0 0 1 1 0 1 0 1 1\n"
                             "p 4 0 0 2 2 0 2 2 1 2 0 1 2\ns 9 9 9 1\nmove 0 0 0 0 0 4\n"
                             "p 3 0 0 0 1 0 0 0 1 0\nrest f 1 1 1 1 0 1 0 1 s 5 5 5 1\n");
    ASSERT_EQ(scene.lights.size(), 4u);
    const auto of_kind = [&](LightKind kind) {
        std::vector<std::vector<std::uint32_t>> found;
        for (const Light& light : scene.lights)
            if (light.kind == kind) found.push_back(light.primitives);
        return found;
    };
    using Numbers = std::vector<std::vector<std::uint32_t>>;
    EXPECT_EQ(of_kind(LightKind::triangles), (Numbers{{0, 1}, {4}}));
    EXPECT_EQ(of_kind(LightKind::rectangle), (Numbers{{2}}));
    EXPECT_EQ(of_kind(LightKind::sphere), (Numbers{{3}}));
    for (const Light& light : scene.lights) {
        EXPECT_EQ(light.intensity, vec3(3, 2, 1));
        for (const std::uint32_t primitive : light.primitives)
            EXPECT_TRUE(light.samples.contains(scene.geometry.bounds(primitive)));
    }
}

TEST(NffExtension, reads_physical_surfaces) {
    const Scene scene = read(view +
                             "surface oren_nayar colour 0.1 0.2 0.3 roughness 0.5\ns 0 0 0 1\n"
                             "surface conductor roughness 0.25 eta 1 2 3 absorption 4 5 6\n"
                             "s 0 0 0 1\nsurface dielectric index 1.5 s 0 0 0 1\n"
                             "surface nff specular 0.5 shine 30 gloss 100 transmit 0.25 "
                             "diffuse 0.125\ns 0 0 0 1\nsurface phong s 0 0 0 1\n"
                             "surface cook_torrance s 0 0 0 1\n");
    EXPECT_EQ(scene.material(0).model, SurfaceModel::oren_nayar);
    EXPECT_EQ(scene.material(0).roughness, 0.5f);
    EXPECT_EQ(scene.material(1).eta, vec3(1, 2, 3));
    EXPECT_EQ(scene.material(1).absorption, vec3(4, 5, 6));
    EXPECT_EQ(scene.material(2).refraction_index, 1.5f);
    EXPECT_EQ(scene.material(3).model, SurfaceModel::nff);
    EXPECT_EQ(scene.material(3).gloss, 100);
    EXPECT_EQ(scene.material(3).transmittance, 0.25f);
    EXPECT_EQ(scene.material(4).model, SurfaceModel::phong);
    EXPECT_EQ(scene.material(5).model, SurfaceModel::cook_torrance);
}

TEST(NffExtension, is_loaded_frame_by_frame) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.nff", view + "move 0 0 0 8 0 0\ns 0 0 0 1\n");
    const auto begin = [](const Scene& scene) { return motion_of(scene, 0).translation[0].x; };
    EXPECT_EQ(begin(load_scene(file)), 0);
    EXPECT_EQ(begin(load_scene(file + ":frame=3,frames=4")), 6);
    EXPECT_EQ(begin(load_frame(file, 1, 4)), 2);
    EXPECT_EQ(begin(load_frame(file + ":precision=watertight", 1, 4)), 2);
    EXPECT_EQ(load_frame(file + ":shutter=0.5", 0, 1).geometry.motion(1).translation[1].x, 4);
    EXPECT_EQ(digest(load_frame("spd/tetra:size=1", 3, 5)), digest(load_scene("spd/tetra:size=1")));
    EXPECT_EQ(begin(load_frame(file + ":frame=3,frames=4", 0, 1)), 6);
    EXPECT_TRUE(contains(message_of([&] { load_scene(file + ":frame=1"); }), "has 1 frame"));
    EXPECT_TRUE(contains(message_of([&] { load_scene(file + ":frame=4,frames=4"); }), "frame=4"));
    EXPECT_TRUE(contains(message_of([&] { load_scene(file + ":shutter=2"); }), "from 0 to 1"));
    EXPECT_TRUE(contains(message_of([&] { load_frame(file + ":frame=0", 0, 2); }), "twice"));
    EXPECT_TRUE(contains(message_of([&] { load_frame(file, 2, 2); }), "frame 2 of 2"));
}

TEST(NffExtension, reads_the_example_of_its_readme) {
    const std::string readme = read_file(data_folder() / "README.md");
    const std::size_t begin = readme.find("```\nv from") + 4;
    const Scene scene = read(readme.substr(begin, readme.find("```", begin) - begin));
    EXPECT_EQ(scene.geometry.size(), 3u);
    EXPECT_TRUE(scene.camera.lens);
    EXPECT_EQ(scene.lights.at(0).primitives.size(), 1u);
    const dvec3 hub = move_to_world(motion_of(scene, 1), 1, dvec3(0, 2, 0));
    EXPECT_LT(length(hub - dvec3(0, 0, 0)), 1e-6);  // half a turn in half a frame
}

struct Malformed {
    std::string text;
    std::string where, what;
};

std::ostream& operator<<(std::ostream& out, const Malformed& malformed) {
    return out << malformed.what;
}

class MalformedNffExtension : public testing::TestWithParam<Malformed> {};

TEST_P(MalformedNffExtension, is_refused_with_line_and_remedy) {
    const std::string message = message_of([] { read(GetParam().text); });
    EXPECT_TRUE(contains(message, "test.nff:" + GetParam().where + ": "));
    EXPECT_TRUE(contains(message, GetParam().what));
}

const std::string shines = view + "surface lambert emission 1 1 1\n";

INSTANTIATE_TEST_SUITE_P(
    Table, MalformedNffExtension,
    testing::Values(
        Malformed{view + "light bulb 1 2 3\n", "8", "'bulb' is no kind of light; there are point"},
        Malformed{view + "light\n", "9", "'' is no kind of light"},
        Malformed{view + "light point 1 2 3 1 -1 1\n", "8", "must not be negative"},
        Malformed{view + "light directional 0 0 0 1 1 1\n", "8", "direction is zero"},
        Malformed{view + "light spot 0 0 0 0 0 1 30 20 1 1 1\n", "8", "inner half-angle"},
        Malformed{view + "light spot 0 0 0 0 0 1 30 120 1 1 1\n", "8", "from 0 to 90"},
        Malformed{view + "light rectangle 0 0 0 1 0 0 1 1 0 1 1 1\n", "8", "right angles"},
        Malformed{view + "light rectangle 0 0 0 1 0 0 0 0 0 1 1 1\n", "8", "right angles"},
        Malformed{view + "light rectangle 3e38 0 0 3e38 0 0 0 1 0 1 1 1\n", "8", "too large"},
        Malformed{view + "light disc 0 0 0 0 1 0 0 1 1 1\n", "8", "radius must be more than 0"},
        Malformed{view + "light disc 0 0 0 0 1 0 1 1 1 1 visible\n", "8", "cannot be visible"},
        Malformed{view + "light sphere 0 0 0 1 1 1 1 visible visible\n", "8", "second 'visible'"},
        Malformed{view + "light sphere 0 0 0 1 1 1 1 strata 0 1\n", "8", "strata"},
        Malformed{view + "light point 1 2 3 1 1 1 visible\n", "8", "unknown entity 'visible'"},
        Malformed{view + "surface wood\n", "8", "'wood' is no model of a surface; there are nff"},
        Malformed{view + "surface lambert roughness 2\n", "8", "from 0"},
        Malformed{view + "surface lambert colour 1 1\n", "9", "colour"},
        Malformed{view + "surface lambert colour 1 1 1 colour 1 1 1\n", "8", "second 'colour'"},
        Malformed{view + "surface lambert colur 1 1 1\n", "8", "unknown entity 'colur'"},
        Malformed{view + "surface dielectric\n", "8", "'index' is missing"},
        Malformed{view + "surface lambert emission 1 1 -1\n", "8", "emission"},
        Malformed{shines + "c 0 0 0 1 0 0 1 1\n", "9", "a cone cannot emit light"},
        Malformed{shines + "p 4 0 0 0 1 0 0 2 2 0 0 1 0\n", "9", "cut it into triangles"},
        Malformed{view + "move 0 0 0 1 1\n", "9", "shift at the beginning"},
        Malformed{view + "turn 0 0 0 0 0 0 0 90\n", "8", "axis of a turn is zero"},
        Malformed{view + "vturn 0 0 0 0 1 0 0 900\n", "9", "a turn by 900"},
        Malformed{view + "move 3e38 0 0 3e38 0 0 turn 0 0 0 1 0 0 0 300 s 0 0 0 1\n", "8",
                  "a turn by 300"},
        Malformed{view + "shutter 0.5 0.25\n", "8", "in this order"},
        Malformed{view + "shutter 0 1.5\n", "8", "from 0 to 1"},
        Malformed{view + "move 0 0 0 1 1 1 s 0 0 0 1 shutter 0 1\n", "8",
                  "before the first thing that moves"},
        Malformed{view + "lens focal 1 stop 2\n", "8", "'focus' is missing"},
        Malformed{view + "lens focal 1 stop 2 focus 1\n", "8", "beyond the focal length"},
        Malformed{view + "lens focal 1 stop 2 focus 3 blades 2\n", "8", "blades"},
        Malformed{view + "lens focal 1 stop 2 focus 3 stop 4\n", "8", "a second 'stop'"},
        Malformed{view + "lens focal 1 stop 2 focus 3 lens focal 1 stop 2 focus 3\n", "8",
                  "a second lens"}));

}  // namespace
}  // namespace rayshoot
