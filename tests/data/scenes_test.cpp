#include "data/scenes.h"

#include "data/gallery_scenes.h"
#include "data/mesh_catalogue.h"
#include "tests/data/messages.h"
#include "tests/data/temporary_folder.h"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace rayshoot {
namespace {

std::string refusal(const std::string& scene) {
    return message_of([&] { load_scene(scene); });
}

/// An environment variable set for a while.
class Setting {
public:
    Setting(const char* name, const std::string& value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        setenv(name, value.c_str(), 1);
    }
    ~Setting() { old_.empty() ? unsetenv(name_) : setenv(name_, old_.c_str(), 1); }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

private:
    const char* name_;
    std::string old_;
};

const std::string tetrahedron =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

TEST(SceneString, names_a_generator_with_options) {
    const Scene scene = load_scene("spd/tetra:size=2,precision=watertight");
    EXPECT_EQ(scene.geometry.size(), 16u);
    EXPECT_EQ(scene.geometry.precision(), Precision::watertight);
    EXPECT_EQ(scene.name, "spd/tetra:size=2,precision=watertight");
    EXPECT_EQ(load_scene("spd/tetra:size=2").geometry.precision(), Precision::standard);
}

TEST(SceneString, names_a_file_with_options) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.off", tetrahedron);
    EXPECT_EQ(load_scene(file).geometry.size(), 4u);
    EXPECT_EQ(load_scene(file + ":loop=2").geometry.size(), 64u);
    EXPECT_EQ(load_scene(file + ":precision=default,loop=1").geometry.size(), 16u);
    const std::string odd = folder.write("a:b=c.off", tetrahedron);
    EXPECT_EQ(load_scene(odd).geometry.size(), 4u);
}

TEST(SceneString, takes_a_relative_path_below_the_collection) {
    const TemporaryFolder folder;
    folder.write("meshes/cow.obj.xz", "");
    folder.write("some/a.off", tetrahedron);
    const Setting setting("RAYSHOOT_SCENES", folder.path().string());
    EXPECT_EQ(load_scene("some/a.off").geometry.size(), 4u);
    EXPECT_TRUE(contains(refusal("mesh/cow"), "damaged"));
}

TEST(SceneString, finds_material_libraries_beside_the_file) {
    const TemporaryFolder folder;
    folder.write("m.mtl", "newmtl red\nKd 1 0 0\n");
    const std::string file =
        folder.write("a.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n");
    EXPECT_EQ(load_scene(file).material(0).colour, vec3(1, 0, 0));
}

TEST(SceneString, that_names_nothing_is_refused_with_what_exists) {
    EXPECT_TRUE(contains(refusal("spd/ball"), "'spd/ball' is no scene; there are spd/balls"));
    EXPECT_TRUE(contains(refusal("mesh/none"), "mesh/bunny"));
    EXPECT_TRUE(contains(refusal(""), "empty"));
    EXPECT_TRUE(contains(refusal(":size=3"), "empty"));
    EXPECT_TRUE(contains(refusal("none.ply"), "none.ply: there is no such file"));
    EXPECT_TRUE(contains(refusal("."), "is a directory"));
    EXPECT_TRUE(contains(refusal("data"), "is a directory"));
    EXPECT_TRUE(contains(refusal("/dev/zero"), "not a regular file"));
    const TemporaryFolder folder;
    EXPECT_TRUE(contains(refusal(folder.write("a.txt", "x")), "does not end in .nff"));
}

TEST(SceneString, with_bad_options_is_refused) {
    EXPECT_TRUE(contains(refusal("spd/balls:size"), "key=value"));
    EXPECT_TRUE(contains(refusal("spd/balls:sise=3"), "sise"));
    EXPECT_TRUE(contains(refusal("spd/balls:size=1000000"), "size=1000000"));
    EXPECT_TRUE(contains(refusal("spd/balls:size=-1"), "size=-1"));
    EXPECT_TRUE(contains(refusal("spd/balls:precision=double"), "precision=double"));
    EXPECT_TRUE(contains(refusal("soup:count=1e99"), "count=1e99"));
    const TemporaryFolder folder;
    const std::string file = folder.write("a.off", tetrahedron);
    EXPECT_TRUE(contains(refusal(file + ":size=3"), "unknown option 'size'"));
    EXPECT_TRUE(contains(refusal(file + ":loop=9"), "loop=9 is not a whole number from 0 to 8"));
    EXPECT_TRUE(contains(refusal(file + ":loop=two"), "loop=two"));
}

TEST(SceneList, names_every_scene_once_and_what_gets_a_missing_one) {
    const TemporaryFolder empty;
    const Setting no_data("RAYSHOOT_DATA", empty.path().string());
    const Setting no_scenes("RAYSHOOT_SCENES", empty.path().string());
    std::vector<std::string> names;
    for (const SceneInfo& scene : list_scenes()) {
        names.push_back(scene.name);
        EXPECT_FALSE(scene.summary.empty()) << scene.name;
        EXPECT_EQ(scene.available, scene.command.empty()) << scene.name;
        const bool in_a_file =
            scene.name.starts_with("mesh/") || scene.name.starts_with("gallery/");
        EXPECT_EQ(scene.available, !in_a_file) << scene.name;
        EXPECT_EQ(scene.command.find(empty.path().string()), std::string::npos);
        if (!scene.available) {
            EXPECT_TRUE(contains(refusal(scene.name), scene.command));
        }
    }
    std::ranges::sort(names);
    EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
    for (const char* name : {"spd/balls", "spd/gears", "soup", "mesh/bunny", "mesh/dragon"})
        EXPECT_TRUE(std::ranges::binary_search(names, name)) << name;
}

TEST(SceneList, names_the_files_of_the_collection) {
    const TemporaryFolder folder;
    folder.write("x/a.off", tetrahedron);
    folder.write("x/notes.txt", "");
    const Setting setting("RAYSHOOT_SCENES", folder.path().string());
    const auto scenes = list_scenes();
    const auto found = std::ranges::find(scenes, "x/a.off", &SceneInfo::name);
    ASSERT_NE(found, scenes.end());
    EXPECT_EQ(load_scene(found->name).geometry.size(), 4u);
    EXPECT_EQ(std::ranges::find(scenes, "x/notes.txt", &SceneInfo::name), scenes.end());
}

TEST(Gallery, has_a_name_for_each_of_its_files) {
    std::set<std::string> files, names;
    for (const auto& file : std::filesystem::directory_iterator(data_folder() / "gallery"))
        files.insert("gallery/" + file.path().stem().string());
    for (const GalleryScene& scene : gallery_scenes()) names.insert(std::string(scene.name));
    EXPECT_EQ(names, files);
}

TEST(Gallery, scenes_are_those_of_their_files) {
    for (const GalleryScene& shown : gallery_scenes()) {
        const Scene scene = load_scene(shown.name);
        EXPECT_EQ(scene.name, shown.name);
        EXPECT_EQ(digest(scene), digest(load_scene(file_of(shown).string()))) << shown.name;
    }
}

TEST(Gallery, scenes_have_frames) {
    const auto third = load_frame("gallery/wagon_wheel", 2, 12);
    EXPECT_EQ(digest(third), digest(load_scene("gallery/wagon_wheel:frame=2,frames=12")));
    EXPECT_NE(digest(third), digest(load_scene("gallery/wagon_wheel:frame=3,frames=12")));
    EXPECT_TRUE(contains(refusal("gallery/glass:size=2"), "unknown option 'size'"));
}

TEST(MeshCatalogue, meshes_of_the_package_have_their_triangles) {
    const std::vector<std::pair<const char*, std::uint32_t>> expected{
        {"mesh/bunny00", 75000}, {"mesh/elephant", 88928}, {"mesh/armadillo", 52000}};
    for (const auto& [name, triangles] : expected) {
        if (!locate(*find_mesh(name))) GTEST_SKIP() << name << " is missing; run ./setup.sh";
        EXPECT_NEAR(load_scene(name).geometry.size(), triangles, 1000) << name;
    }
}

}  // namespace
}  // namespace rayshoot
