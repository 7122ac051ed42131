#pragma once

#include "accel/core/catalogue.h"
#include "bench/gallery/exhibits.h"
#include "tracer/ray_counts.h"

#include <filesystem>

/// Renders exhibits, and hangs them on a page.
namespace rayshoot::gallery {

/// What exhibits are rendered with.
struct Easel {
    const Catalogue& catalogue;
    std::string structure = "bvh8";
    int threads = 1;
};

struct Hung {
    Exhibit exhibit;
    RayCounts counts;    ///< of all frames
    double seconds = 0;  ///< of rendering them; neither loading nor building
    double samples = 0;  ///< camera rays a pixel, in the mean
};

/// Renders an exhibit into `folder`/name.png.
Hung hang(const Exhibit& exhibit, const Easel& easel, const std::filesystem::path& folder);

/// The command that renders the same pixels; frames go into files of their own.
std::string command_for(const Exhibit& exhibit, const std::string& structure);

/// `folder`/README.md: the pictures with caption, command, rays and seconds.
void write_page(std::span<const Hung> hung, const std::string& structure,
                const std::filesystem::path& folder);

}  // namespace rayshoot::gallery
