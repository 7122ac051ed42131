#include "data/gallery_scenes.h"

#include <algorithm>
#include <array>

#include "data/mesh_catalogue.h"

namespace rayshoot {
namespace {

constexpr std::array<GalleryScene, 11> scenes{{
    {"gallery/blurred_reflection", "columns on three mirrors, from sharp to dull"},
    {"gallery/camera_motion", "columns, seen by a camera that moves and turns"},
    {"gallery/cornell_box", "the Cornell box, in physical units"},
    {"gallery/depth_of_field", "a row of balls behind a lens of six blades"},
    {"gallery/glass", "dielectrics by GGX, from smooth to rough, and a coated diffuser"},
    {"gallery/hard_shadow", "soft_shadow under a point lamp"},
    {"gallery/matt", "Lambert's law, and Oren and Nayar's"},
    {"gallery/metals", "gold by GGX, from smooth to rough"},
    {"gallery/motion_blur", "a ball that flies, a dumb-bell that turns"},
    {"gallery/soft_shadow", "a ball and a post under a square lamp"},
    {"gallery/wagon_wheel", "a wheel of twelve spokes that seems to turn backwards"},
}};

}  // namespace

std::span<const GalleryScene> gallery_scenes() { return scenes; }

const GalleryScene* find_gallery_scene(std::string_view name) {
    const auto found = std::ranges::find(scenes, name, &GalleryScene::name);
    return found == scenes.end() ? nullptr : &*found;
}

std::filesystem::path file_of(const GalleryScene& scene) {
    return data_folder() / (std::string(scene.name) + ".nff");
}

std::string how_to_get(const GalleryScene& scene) {
    return "set RAYSHOOT_DATA to the folder data of rayshoot's source, which holds " +
           std::string(scene.name) + ".nff";
}

}  // namespace rayshoot
