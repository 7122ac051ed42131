#include "tracer/render.h"

#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "bench/output/machine.h"
#include "bench/output/progress.h"
#include "bench/timing/clock.h"
#include "data/scenes.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot render`: an image through a structure.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

struct RenderArguments {
    std::string scene, structure = "bvh", size, out;
    int spp = 1;
    int threads = processor_count();
    bool json = false;
};

Json render_document(const RenderArguments& arguments, const Catalogue& catalogue) {
    require_writable(arguments.out);
    require_spec(catalogue, arguments.structure);
    RenderSettings settings;
    settings.threads = require_threads(arguments.threads);
    const Stopwatch load_watch;
    const Scene scene = load_scene(arguments.scene);
    const double load_seconds = load_watch.seconds();
    settings.format = image_format(scene, arguments.size, arguments.spp);
    require_takes(catalogue, arguments.structure, scene);
    const Stopwatch build_watch;
    const auto accel = build(catalogue, arguments.structure, build_input(scene, settings.format));
    const double build_seconds = build_watch.seconds();
    ProgressLine line;
    settings.progress = [&](double share, double left) { line.show(share, left, arguments.out); };
    const RenderResult result = render(scene, *accel, settings);
    line.clear();
    write_image(result.image, arguments.out);
    return {{"schema", schema_version},
            {"scene", scene.name},
            {"structure", accel->spec()},
            {"width", settings.format.width},
            {"height", settings.format.height},
            {"spp", settings.format.spp},
            {"threads", settings.threads},
            {"sha256", digest(result.image)},
            {"seconds",
             {{"load", load_seconds}, {"build", build_seconds}, {"render", result.seconds}}}};
}

int render_image(const RenderArguments& arguments, const Invocation& invocation) {
    const Json document = render_document(arguments, invocation.catalogue);
    if (arguments.json) {
        print_json(invocation.out, document);
    } else {
        const double seconds = document["seconds"]["render"];
        invocation.out << arguments.out << ": rendered in " << number_cell(seconds, 3)
                       << " s, SHA-256 of the floats " << document["sha256"].get<std::string>()
                       << '\n';
    }
    return 0;
}

}  // namespace

void add_render(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<RenderArguments>();
    CLI::App* command = app.add_subcommand("render", "Render an image through a structure");
    command->add_option("--scene", arguments->scene, "Scene string or file")->required();
    command->add_option("--structure", arguments->structure, "Structure spec (bvh)");
    command->add_option("--size", arguments->size, "WxH; default 513x513 (SPD, NFF) or 512x512");
    command->add_option("--spp", arguments->spp, "Camera rays per pixel (1)");
    command->add_option("--out", arguments->out, "Image file, .png or .exr")->required();
    command->add_option("--threads", arguments->threads, "Threads (all)");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] {
            return render_image(*arguments, invocation);
        };
    });
}

}  // namespace rayshoot
