#include "bench/gallery/gallery.h"

#include "bench/commands/arguments.h"
#include "bench/output/table.h"
#include "bench/output/whole_file.h"
#include "bench/textbook/pictures.h"
#include "data/scenes.h"
#include "tracer/settings.h"

#include <numeric>

namespace rayshoot::gallery {
namespace {

constexpr int columns = 6;  // of an animation's frames

RenderResult rendered(const Exhibit& exhibit, int frame, const Easel& easel) {
    Scene scene = load_frame(exhibit.scene, frame, exhibit.frames);
    ImageSettings settings;
    apply_settings(exhibit.settings, settings);
    apply_to(scene.camera, settings);
    RenderSettings& how = settings.render;
    const ImageFormat format = image_format(scene, std::string(exhibit.size), how.format.spp);
    how.format.width = format.width;
    how.format.height = format.height;
    how.format.raster = format.raster;
    how.threads = easel.threads;
    require_takes(easel.catalogue, easel.structure, scene);
    const auto accel = build(easel.catalogue, easel.structure, build_input(scene, how));
    return render(scene, *accel, how);
}

std::uint64_t all_rays(const RayCounts& counts) {
    return std::accumulate(
        counts.by_cause.begin(), counts.by_cause.end(), std::uint64_t{0},
        [](std::uint64_t sum, const RayCount& count) { return sum + count.rays; });
}

std::string image_link(const Exhibit& exhibit) {
    return "![" + std::string(exhibit.caption) + "](" + std::string(exhibit.name) + ".png)";
}

/// Exhibits of one effect: side by side, captions below; then how each was made.
std::string wall(std::span<const Hung> hung, const std::string& structure) {
    Table pictures, numbers{{"picture", "samples a pixel", "million rays", "seconds"}, {}};
    std::vector<std::string> captions;
    std::string commands;
    for (const Hung& one : hung) {
        pictures.headings.push_back(image_link(one.exhibit));
        captions.push_back(std::string(one.exhibit.caption));
        commands += command_for(one.exhibit, structure) + "\n";
        numbers.rows.push_back({std::string(one.exhibit.name), number_cell(one.samples, 3),
                                number_cell(static_cast<double>(all_rays(one.counts)) / 1e6, 3),
                                number_cell(one.seconds, 2)});
    }
    pictures.rows.push_back(captions);
    return "## " + std::string(hung.front().exhibit.effect) + "\n\n" + to_markdown(pictures) +
           "\n```\n" + commands + "```\n\n" + to_markdown(numbers) + "\n";
}

}  // namespace

Hung hang(const Exhibit& exhibit, const Easel& easel, const std::filesystem::path& folder) {
    Hung hung;
    hung.exhibit = exhibit;
    std::vector<Image> frames;
    for (int frame = 0; frame < exhibit.frames; ++frame) {
        RenderResult result = rendered(exhibit, frame, easel);
        hung.counts += result.counts;
        hung.seconds += result.seconds;
        frames.push_back(std::move(result.image));
    }
    const double pixels = static_cast<double>(frames.front().pixels().size()) * exhibit.frames;
    hung.samples = static_cast<double>(hung.counts[Cause::camera].rays) / pixels;
    write_image(exhibit.frames > 1 ? textbook::tiled(frames, columns) : frames.front(),
                folder / (std::string(exhibit.name) + ".png"));
    return hung;
}

std::string command_for(const Exhibit& exhibit, const std::string& structure) {
    std::string command = "rayshoot render --scene " + std::string(exhibit.scene) + " --size " +
                          std::string(exhibit.size) + " --settings " +
                          std::string(exhibit.settings);
    if (structure != "bvh8") command += " --structure " + structure;
    if (exhibit.frames > 1) command += " --frames " + std::to_string(exhibit.frames);
    return command + " --out " + std::string(exhibit.name) + ".png";
}

void write_page(std::span<const Hung> hung, const std::string& structure,
                const std::filesystem::path& folder) {
    std::string page =
        "# Gallery\n\nEach effect of the tracer, made by `rayshoot gallery --out DIR`. Below each "
        "row the commands that render its pictures one by one, the rays they took and how "
        "long.\n\n";
    for (auto first = hung.begin(); first != hung.end();) {
        auto last = first;
        while (last != hung.end() && last->exhibit.effect == first->exhibit.effect) ++last;
        page += wall({first, last}, structure);
        first = last;
    }
    write_whole_file(folder / "README.md", page);
}

}  // namespace rayshoot::gallery
