#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/output/whole_file.h"
#include "bench/streams/ray_file.h"
#include "bench/streams/record.h"
#include "data/scenes.h"

#include <CLI/CLI.hpp>

#include <array>
#include <ostream>

/// `rayshoot rays`: records the rays of one kind into a file.
namespace rayshoot {
namespace {

struct RaysArguments {
    std::string scene, kind = "camera", size = "512x512", out;
    int spp = 1;
    bool json = false;
};

int rays(const RaysArguments& arguments, const Invocation& invocation) {
    require_writable_file(arguments.out);
    const std::array kinds{stream_kind(arguments.kind)};
    const ImageFormat format = stream_format(arguments.size, arguments.spp);
    const Scene scene = load_scene(arguments.scene);
    const RayStream stream =
        std::move(record_streams(invocation.catalogue, scene, kinds, format).front());
    write_ray_file(arguments.out, stream);
    if (arguments.json) {
        print_json(invocation.out, {{"schema", schema_version},
                                    {"scene", scene.name},
                                    {"kind", arguments.kind},
                                    {"rays", stream.size()},
                                    {"width", format.width},
                                    {"height", format.height},
                                    {"spp", format.spp}});
    } else {
        invocation.out << arguments.out << ": " << stream.size() << " rays\n";
    }
    return 0;
}

}  // namespace

void add_rays(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<RaysArguments>();
    CLI::App* command = app.add_subcommand("rays", "Record rays into a file");
    command->add_option("--scene", arguments->scene, "Scene string or file")->required();
    command->add_option("--kind", arguments->kind, "camera, shadow, diffuse, random or mirror");
    command->add_option("--size", arguments->size, "WxH (512x512)");
    command->add_option("--spp", arguments->spp, "Camera rays per pixel (1)");
    command->add_option("--out", arguments->out, "Ray file")->required();
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return rays(*arguments, invocation); };
    });
}

}  // namespace rayshoot
