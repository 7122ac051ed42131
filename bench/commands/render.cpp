#include "tracer/render.h"

#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "bench/output/interrupt.h"
#include "bench/output/machine.h"
#include "bench/output/progress.h"
#include "bench/timing/clock.h"
#include "data/scenes.h"
#include "tracer/settings.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iomanip>
#include <ostream>
#include <sstream>

/// `rayshoot render`: an image through a structure.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

constexpr int largest_frames = 9999;   // file names have four digits
constexpr int interrupted_exit = 130;  // as shells say it of SIGINT

struct RenderArguments {
    std::string scene, structure = "bvh8", size, out;
    std::vector<std::string> settings;
    int spp = 1, frames = 1;
    int threads = processor_count();
    bool json = false;
};

ImageSettings image_settings(const RenderArguments& arguments) {
    ImageSettings settings;
    settings.render.format.spp = arguments.spp;
    for (const std::string& text : arguments.settings) apply_settings(text, settings);
    settings.render.threads = require_threads(arguments.threads);
    return settings;
}

/// The file of one frame of several: picture.png becomes picture-0001.png and so on.
std::filesystem::path frame_file(const RenderArguments& arguments, int frame) {
    if (arguments.frames == 1) return arguments.out;
    std::filesystem::path path = arguments.out;
    std::ostringstream name;
    name << path.stem().string() << '-' << std::setw(4) << std::setfill('0') << frame + 1
         << path.extension().string();
    return path.replace_filename(name.str());
}

Json rays_to_json(const RayCounts& counts) {
    Json rays = Json::object();
    for (std::size_t i = 0; i < cause_names.size(); ++i)
        rays[std::string(cause_names[i])] = counts.by_cause[i].rays;
    return rays;
}

struct Rendered {
    Json document;
    bool stopped = false;
};

Rendered render_frame(const RenderArguments& arguments, ImageSettings settings, int frame,
                      const Invocation& invocation) {
    const std::filesystem::path file = frame_file(arguments, frame);
    require_writable(file);
    const Stopwatch load_watch;
    Scene scene = load_frame(arguments.scene, frame, arguments.frames);
    const double load_seconds = load_watch.seconds();
    for (const std::string& note : scene.notes)
        if (frame == 0) invocation.err << "rayshoot: " << note << '\n';
    apply_to(scene.camera, settings);
    RenderSettings& how = settings.render;
    const ImageFormat given = how.format;
    how.format = image_format(scene, arguments.size, given.spp);
    how.format.seed = given.seed;
    require_takes(invocation.catalogue, arguments.structure, scene);
    const Stopwatch build_watch;
    const auto accel = build(invocation.catalogue, arguments.structure, build_input(scene, how));
    const double build_seconds = build_watch.seconds();
    ProgressLine line;
    how.progress = [&](double share, double left) { line.show(share, left, file.string()); };
    const InterruptGuard interrupt;
    how.stopped = [&] { return interrupt.interrupted(); };
    const RenderResult result = render(scene, *accel, how);
    line.clear();
    write_image(result.image, file);
    return {{{"schema", schema_version},
             {"file", file.string()},
             {"scene", scene.name},
             {"structure", accel->spec()},
             {"width", how.format.width},
             {"height", how.format.height},
             {"spp", how.format.spp},
             {"threads", how.threads},
             {"complete", !result.stopped},
             {"sha256", digest(result.image)},
             {"rays", rays_to_json(result.counts)},
             {"seconds",
              {{"load", load_seconds},
               {"build", build_seconds},
               {"render", result.seconds},
               {"answering", result.answering_seconds}}}},
            result.stopped};
}

void print_frame(std::ostream& out, const Json& document) {
    const double seconds = document["seconds"]["render"];
    const double answering = document["seconds"]["answering"];
    const double lanes = document["threads"];
    out << document["file"].get<std::string>() << ": rendered in " << number_cell(seconds, 3)
        << " s, " << number_cell(100 * answering / (seconds * lanes), 3)
        << " % of it in the structure, SHA-256 of the floats "
        << document["sha256"].get<std::string>() << '\n';
    if (!document["complete"]) out << "interrupted: the file holds what was rendered until then\n";
}

int render_image(const RenderArguments& arguments, const Invocation& invocation) {
    require_spec(invocation.catalogue, arguments.structure);
    const ImageSettings settings = image_settings(arguments);
    bool stopped = false;
    for (int frame = 0; frame < arguments.frames && !stopped; ++frame) {
        const Rendered rendered = render_frame(arguments, settings, frame, invocation);
        stopped = rendered.stopped;
        if (arguments.json) print_json(invocation.out, rendered.document);
        else print_frame(invocation.out, rendered.document);
    }
    return stopped ? interrupted_exit : 0;
}

}  // namespace

void add_render(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "Render an image through a structure");
    command->add_option("--scene", arguments->scene, "Scene string or file")->required();
    command->add_option("--structure", arguments->structure, "Structure spec (bvh8)");
    command->add_option("--size", arguments->size, "WxH; default 513x513 (SPD, NFF) or 512x512");
    command->add_option("--spp", arguments->spp, "Camera rays per pixel (1)");
    command
        ->add_option("--settings", arguments->settings,
                     "How the image is sampled, filtered and lit: key=value,... or @FILE of such "
                     "lines; may be repeated, the later one counts")
        ->expected(1);
    command
        ->add_option("--frames", arguments->frames,
                     "Frames of an animation, each in a file of its own: out-0001.png ... (1)")
        ->check(CLI::Range(1, largest_frames));
    command->add_option("--out", arguments->out, "Image file, .png or .exr")->required();
    command->add_option("--threads", arguments->threads, "Threads (all)");
    command->add_flag("--json", arguments->json, "One JSON document a frame on standard output");
    command->footer("Settings:\n" + describe_settings());
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] {
            return render_image(*arguments, invocation);
        };
    });
}

}  // namespace rayshoot
