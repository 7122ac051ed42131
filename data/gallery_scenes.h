#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

/// The scenes of the gallery by name: `gallery/glass` is the file glass.nff in the folder gallery
/// of the data folder.
namespace rayshoot {

struct GalleryScene {
    std::string_view name;     ///< of the scene: "gallery/glass"
    std::string_view summary;  ///< one line: the effect that it shows
};

std::span<const GalleryScene> gallery_scenes();
const GalleryScene* find_gallery_scene(std::string_view name);

/// Where its file is, or is looked for.
std::filesystem::path file_of(const GalleryScene& scene);
/// What to do where it is not there, as one line for the user.
std::string how_to_get(const GalleryScene& scene);

}  // namespace rayshoot
