#include "data/digest.h"

#include "data/nff.h"

#include <gtest/gtest.h>

#include <vector>

namespace rayshoot {
namespace {

void add_bytes(Digest& digest, std::string_view text) {
    digest.add(std::as_bytes(std::span(text)));
}

// The examples of FIPS 180-2, appendix B.
TEST(Digest, of_nothing_and_of_abc_are_the_published_ones) {
    Digest digest;
    EXPECT_EQ(digest.hex(), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    add_bytes(digest, "abc");
    EXPECT_EQ(digest.hex(), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Digest, of_a_million_letters_is_the_published_one) {
    Digest digest;
    add_bytes(digest, std::string(900'000, 'a'));
    for (int i = 0; i < 1000; ++i) add_bytes(digest, std::string(100, 'a'));
    EXPECT_EQ(digest.hex(), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, takes_numbers_little_endian) {
    Digest numbers, bytes;
    numbers.add(std::uint32_t{0x64636261});
    numbers.add(1.0f);
    add_bytes(bytes, std::string_view("abcd\0\0\x80\x3f", 8));
    EXPECT_EQ(numbers.hex(), bytes.hex());
}

TEST(Digest, may_be_continued_after_it_was_read) {
    Digest once, twice;
    once.add(1);
    once.add(2);
    twice.add(1);
    EXPECT_NE(twice.hex(), once.hex());
    twice.add(2);
    EXPECT_EQ(twice.hex(), once.hex());
}

constexpr std::string_view tiny =
    "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 hither 1 resolution 4 4\nl 1 2 3\nf 1 1 1 1 0 1 0 1\n"
    "s 0 0 0 1\np 3 0 0 0 1 0 0 0 1 0\n";

TEST(SceneDigest, depends_on_everything_but_the_name) {
    Scene scene = read_nff(tiny, "a.nff");
    const std::string before = digest(scene);
    EXPECT_EQ(before.size(), 64u);
    scene.name = "another";
    EXPECT_EQ(digest(scene), before);
    std::vector<std::string> digests{before};
    const auto expect_new = [&](const Scene& changed) {
        for (const std::string& old : digests) EXPECT_NE(digest(changed), old);
        digests.push_back(digest(changed));
    };
    scene.background.y = 1;
    expect_new(scene);
    scene.camera.angle = 46;
    expect_new(scene);
    scene.lights[0].position.x = 2;
    expect_new(scene);
    scene.materials[0].specular = 0.5f;
    expect_new(scene);
    scene.material_of[1] = 1;
    expect_new(scene);
    scene.hierarchy.emplace();
    expect_new(scene);
    scene.hierarchy->groups.push_back({Sphere{vec3(1), 2}, {}, {1}});
    expect_new(scene);
    scene.camera.lens = Lens{0.1f, 2, 3, 0, 0};
    expect_new(scene);
    scene.camera.lens->blades = 5;
    expect_new(scene);
    scene.camera.motion = Motion{.translation = {vec3(0), vec3(1)}};
    expect_new(scene);
    scene.camera.shutter_close = 0.5f;
    expect_new(scene);
    scene.camera.shutter_open = 0.25f;
    expect_new(scene);
    expect_new(read_nff(tiny, "a.nff", Precision::watertight));
}

TEST(SceneDigest, depends_on_the_fields_beyond_nff_and_on_whose_they_are) {
    Scene scene = read_nff(tiny, "a.nff");
    scene.materials.push_back(scene.materials[0]);
    scene.lights.push_back(scene.lights[0]);
    const std::string before = digest(scene);
    std::vector<std::string> digests{before};
    for (const std::size_t i : {0u, 1u}) {
        const auto expect_new = [&](auto change) {
            Scene changed = scene;
            change(changed.materials[i], changed.lights[i]);
            for (const std::string& old : digests) EXPECT_NE(digest(changed), old);
            digests.push_back(digest(changed));
        };
        expect_new([](Material& m, Light&) { m.model = SurfaceModel::conductor; });
        expect_new([](Material& m, Light&) { m.roughness = 0.5f; });
        expect_new([](Material& m, Light&) { m.gloss = 0.5f; });
        expect_new([](Material& m, Light&) { m.eta.y = 0.5f; });
        expect_new([](Material& m, Light&) { m.absorption.y = 0.5f; });
        expect_new([](Material& m, Light&) { m.emission.y = 0.5f; });
        expect_new([](Material&, Light& light) { light.falloff = Falloff::inverse_square; });
    }
}

}  // namespace
}  // namespace rayshoot
