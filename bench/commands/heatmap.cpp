#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "bench/heatmap/heat_maps.h"
#include "data/scenes.h"
#include "tracer/settings.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <ostream>

/// `rayshoot heatmap`: what each pixel costs, in one scale of colours for all structures.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

struct HeatmapArguments {
    std::string scene, quantity = "tests", size, spacing = "linear", out;
    std::vector<std::string> structures, settings;
    std::optional<double> top;
    int spp = 1;
    int repetitions = 3;
    bool json = false;
};

Spacing parse_spacing(const std::string& name) {
    if (name == "linear") return Spacing::linear;
    if (name == "log") return Spacing::logarithmic;
    throw std::invalid_argument("unknown scale \"" + name + "\"; there are linear and log");
}

void require_valid(const HeatmapArguments& arguments, const Catalogue& catalogue) {
    for (const std::string& spec : arguments.structures) require_spec(catalogue, spec);
    if (arguments.top && !(std::isfinite(*arguments.top) && *arguments.top > 0))
        throw std::invalid_argument(
            "--top must be a number above 0: it is the value of the last colour");
    if (arguments.repetitions < 1) throw std::invalid_argument("--repetitions must be 1 or more");
}

Json write_maps(const HeatMaps& heat, const std::filesystem::path& folder) {
    const std::vector<HeatMapFiles> files = write_heat_maps(heat, folder);
    Json rows = Json::array();
    for (std::size_t i = 0; i < files.size(); ++i) {
        const CostSummary summary = summarise(heat.maps[i]);
        rows.push_back({{"structure", heat.structures[i]},
                        {"sum", summary.sum},
                        {"mean", summary.mean},
                        {"largest", summary.largest},
                        {"largest_at", {summary.largest_at.x, summary.largest_at.y}},
                        {"image", files[i].image},
                        {"values", files[i].values}});
    }
    return rows;
}

std::string to_text(const Json& document) {
    Table table{{"structure", "sum", "mean", "largest", "at", "image"}, {}};
    for (const Json& row : document["structures"]) {
        table.rows.push_back({row["structure"], short_number(row["sum"].get<double>(), 12),
                              number_cell(row["mean"].get<double>()),
                              short_number(row["largest"].get<double>(), 7),
                              row["largest_at"].dump(), row["image"]});
    }
    const bool timed = document["quantity"] == "time";
    return document["unit"].get<std::string>() + " per pixel; one scale, 0 to " +
           short_number(document["scale"]["high"].get<double>(), 7) + " (colour_bar.png)\n\n" +
           to_text(table) +
           (timed
                ? "\nThe least of all rounds. Batches of one pixel are slower than full ones, and "
                  "each has two\nlooks at the clock in it.\n"
                : "");
}

Json heatmap_document(const HeatmapArguments& arguments, const Catalogue& catalogue) {
    require_valid(arguments, catalogue);
    const Cost cost = cost_named(arguments.quantity);
    const Spacing spacing = parse_spacing(arguments.spacing);
    Scene scene = load_scene(arguments.scene);
    ImageSettings image;
    image.render.format.spp = arguments.spp;
    for (const std::string& text : arguments.settings) apply_settings(text, image);
    apply_to(scene.camera, image);
    const ImageFormat given = image.render.format;
    image.render.format = image_format(scene, arguments.size, given.spp);
    image.render.format.seed = given.seed;
    const RenderSettings settings = settings_by_pixel(image.render);
    const ImageFormat& format = settings.format;
    std::vector<std::unique_ptr<Accel>> accels;
    for (const std::string& spec : arguments.structures) {
        require_takes(catalogue, spec, scene);
        accels.push_back(build(catalogue, spec, build_input(scene, settings)));
    }
    std::filesystem::create_directories(arguments.out);  // before the long part, not after it
    HeatMaps heat = measure_heat(scene, accels, settings, cost, arguments.repetitions);
    heat.scale.spacing = spacing;
    if (arguments.top) heat.scale.high = *arguments.top;
    return {{"schema", schema_version},
            {"document", "heatmap"},
            {"scene", scene.name},
            {"quantity", name_of(cost)},
            {"unit", unit_of(cost)},
            {"width", format.width},
            {"height", format.height},
            {"spp", format.spp},
            {"batch", settings.batch},
            {"repetitions", cost == Cost::time ? Json(arguments.repetitions) : Json(nullptr)},
            {"scale",
             {{"low", heat.scale.low}, {"high", heat.scale.high}, {"spacing", arguments.spacing}}},
            {"structures", write_maps(heat, arguments.out)}};
}

int heatmap(const HeatmapArguments& arguments, const Invocation& invocation) {
    const Json document = heatmap_document(arguments, invocation.catalogue);
    if (arguments.json) print_json(invocation.out, document);
    else invocation.out << to_text(document);
    return 0;
}

void add_options(CLI::App& command, HeatmapArguments& arguments) {
    command.add_option("--scene", arguments.scene, "Scene string or file")->required();
    command.add_option("--structure", arguments.structures, "Structure specs")->required();
    command.add_option("--quantity", arguments.quantity,
                       "tests (default), steps, boxes or time, per pixel");
    command.add_option("--size", arguments.size, "WxH; default 513x513 (SPD, NFF) or 512x512");
    command.add_option("--spp", arguments.spp, "Camera rays per pixel (1)");
    command
        .add_option("--settings", arguments.settings,
                    "As of `rayshoot render`, with a filter no wider than a pixel")
        ->expected(1);
    command.add_option("--scale", arguments.spacing, "linear (default) or log, of 1 + value");
    command.add_option("--top", arguments.top,
                       "Value of the last colour; default: the largest of all structures");
    command.add_option("--repetitions", arguments.repetitions,
                       "Rounds of --quantity time, of which the least is kept (3)");
    command.add_option("--out", arguments.out, "Folder for the images and values")->required();
    command.add_flag("--json", arguments.json, "One JSON document on standard output");
}

}  // namespace

void add_heatmap(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<HeatmapArguments>();
    CLI::App* command = app.add_subcommand("heatmap", "What each pixel of an image costs");
    add_options(*command, *arguments);
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return heatmap(*arguments, invocation); };
    });
}

}  // namespace rayshoot
