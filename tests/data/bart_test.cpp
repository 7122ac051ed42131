#include "data/aff.h"
#include "data/file.h"
#include "data/mesh_catalogue.h"
#include "data/scenes.h"

#include "tests/data/messages.h"
#include "tests/data/temporary_folder.h"

#include <cstdlib>
#include <set>

/// BART's kitchen from $RAYSHOOT_SCENES, unpacked there or packed, against the counts in the
/// collection's README.
namespace rayshoot {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> find_file(const fs::path& folder, const std::string& name) {
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error))
        if (entry.path().filename() == name) return entry.path();
    return std::nullopt;
}

class Kitchen : public testing::Test {
protected:
    void SetUp() override {
        const auto collection = scene_collection();
        if (!collection) GTEST_SKIP() << "RAYSHOOT_SCENES is not set";
        path_ = find_file(*collection, "kitchen.aff");
        if (path_) return;
        const auto packed = find_file(*collection, "bart_kitchen_aff.tar.xz");
        if (!packed) GTEST_SKIP() << "RAYSHOOT_SCENES has no BART kitchen";
        const std::string unpack =
            "tar -xf '" + packed->string() + "' -C '" + unpacked_.path().string() + "'";
        ASSERT_EQ(std::system(unpack.c_str()), 0) << unpack;
        path_ = find_file(unpacked_.path(), "kitchen.aff");
        ASSERT_TRUE(path_);
    }

    AffModel model() const {
        return read_aff_model(read_file(*path_), path_->string(), [this](const std::string& name) {
            return read_file(path_->parent_path() / name);
        });
    }

    TemporaryFolder unpacked_;
    std::optional<fs::path> path_;
};

TEST_F(Kitchen, has_the_counts_of_the_collections_table) {
    const AffModel kitchen = model();
    EXPECT_EQ(kitchen.counts, (AffCounts{.files = 52,
                                         .meshes = 255,
                                         .static_transforms = 347,
                                         .animated_transforms = 5,
                                         .key_frames = 6,
                                         .lights = 6}));
    EXPECT_EQ(kitchen.animation.frames, 800);
    EXPECT_EQ(kitchen.animation.end, 20);
}

std::set<std::uint32_t> motions(const Scene& scene) {
    std::set<std::uint32_t> used;
    for (std::uint32_t i = 0; i < scene.geometry.size(); ++i)
        if (scene.geometry.ref(i).motion != no_motion) used.insert(scene.geometry.ref(i).motion);
    return used;
}

TEST_F(Kitchen, moves_its_car_its_wheels_and_its_camera) {
    const AffModel kitchen = model();
    const auto frame = [&](int number) {
        return aff_scene(kitchen, "kitchen.aff", Precision::standard, {.number = number});
    };
    const Scene begin = frame(0), middle = frame(400);
    EXPECT_GT(begin.geometry.size(), 100000u);
    EXPECT_EQ(begin.geometry.size(), middle.geometry.size());
    EXPECT_EQ(middle.lights.size(), 6u);
    EXPECT_EQ(motions(middle).size(), 5u);  // the car's own transform and its four wheels' ones
    EXPECT_TRUE(middle.camera.motion);
    // At the key of 10.5 s the camera is where the file says; 10.5 s are 419.475 frames.
    const Scene at_key = aff_scene(kitchen, "kitchen.aff", Precision::standard,
                                   {.number = 21, .of = 41, .shutter = 0});
    EXPECT_LT(length(at_key.camera.from - vec3(3.07f, 0.47f, 1.05f)), 1e-5f);
    EXPECT_FALSE(at_key.camera.motion);
}

TEST_F(Kitchen, is_a_scene_by_its_path) {
    const Scene scene = load_scene(path_->string() + ":frame=200,shutter=0.25");
    EXPECT_GT(scene.geometry.size(), 100000u);
    for (const std::uint32_t material : scene.material_of)
        EXPECT_LT(material, scene.materials.size());
    EXPECT_FALSE(scene.notes.empty());
}

}  // namespace
}  // namespace rayshoot
