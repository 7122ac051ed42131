#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "bench/heatmap/cost_map.h"
#include "bench/output/machine.h"
#include "bench/output/progress.h"
#include "bench/output/whole_file.h"
#include "data/scenes.h"
#include "tracer/colour_bar.h"
#include "tracer/colour_map.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <ostream>

/// `rayshoot heatmap`: what each pixel costs, in one scale of colours for all structures.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

struct HeatmapArguments {
    std::string scene, quantity = "tests", size, spacing = "linear", out;
    std::vector<std::string> structures;
    std::optional<double> top;
    int spp = 1;
    int repetitions = 3;
    bool json = false;
};

/// The maps of all structures, and what they are maps of.
struct HeatMaps {
    Cost cost;
    std::vector<std::string> structures;  ///< canonical specs
    std::vector<ScalarImage> maps;
    ColourScale scale;
};

Spacing parse_spacing(const std::string& name) {
    if (name == "linear") return Spacing::linear;
    if (name == "log") return Spacing::logarithmic;
    throw std::invalid_argument("unknown scale \"" + name + "\"; there are linear and log");
}

void require_valid(const HeatmapArguments& arguments, const Catalogue& catalogue) {
    for (const std::string& spec : arguments.structures) require_spec(catalogue, spec);
    if (arguments.top && !(*arguments.top > 0))
        throw std::invalid_argument(
            "--top must be more than 0: it is the value of the last colour");
    if (arguments.repetitions < 1) throw std::invalid_argument("--repetitions must be 1 or more");
}

/// Round by round of each structure once, so that a machine that drifts drifts for all.
std::vector<ScalarImage> measure(const Scene& scene,
                                 const std::vector<std::unique_ptr<Accel>>& accels,
                                 const RenderSettings& settings, Cost cost, int repetitions) {
    const int rounds = cost == Cost::time ? repetitions : 1;  // counts repeat exactly
    Progress progress(accels.size() * static_cast<std::size_t>(rounds));
    std::vector<ScalarImage> maps;
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < accels.size(); ++i) {
            progress.advance(accels[i]->spec());
            ScalarImage map = cost_map(scene, *accels[i], settings, cost);
            if (round == 0) maps.push_back(std::move(map));
            else keep_least(maps[i], map);
        }
    }
    return maps;
}

/// "bvh-leaf-2"; made different where specs differ in punctuation alone.
std::vector<std::string> file_names(const std::vector<std::string>& structures) {
    std::vector<std::string> names;
    for (const std::string& spec : structures) {
        std::string name = slug(spec);
        for (int other = 2; std::ranges::count(names, name) > 0; ++other)
            name = slug(spec) + "-" + std::to_string(other);
        names.push_back(name);
    }
    return names;
}

/// Column x, column y, and a column for each structure.
std::string to_csv(const HeatMaps& heat) {
    Table heading{{"x", "y"}, {}};
    heading.headings.insert(heading.headings.end(), heat.structures.begin(), heat.structures.end());
    std::string text = to_csv(heading);
    for (int y = 0; y < heat.maps.front().height(); ++y) {
        for (int x = 0; x < heat.maps.front().width(); ++x) {
            text += std::to_string(x) + "," + std::to_string(y);
            for (const ScalarImage& map : heat.maps) text += "," + number_cell(map.at(x, y), 9);
            text += "\r\n";
        }
    }
    return text;
}

Json write_maps(const HeatMaps& heat, const fs::path& folder) {
    const std::vector<std::string> names = file_names(heat.structures);
    Json rows = Json::array();
    for (std::size_t i = 0; i < names.size(); ++i) {
        write_image(coloured(heat.maps[i], heat.scale), folder / (names[i] + ".png"));
        write_image(grey(heat.maps[i]), folder / (names[i] + ".exr"));
        const CostSummary summary = summarise(heat.maps[i]);
        rows.push_back({{"structure", heat.structures[i]},
                        {"sum", summary.sum},
                        {"mean", summary.mean},
                        {"largest", summary.largest},
                        {"largest_at", {summary.largest_at.x, summary.largest_at.y}},
                        {"image", names[i] + ".png"},
                        {"values", names[i] + ".exr"}});
    }
    write_image(colour_bar(heat.scale, heat.maps.front().width()), folder / "colour_bar.png");
    write_whole_file(folder / "values.csv", to_csv(heat));
    return rows;
}

std::string to_text(const Json& document) {
    Table table{{"structure", "sum", "mean", "largest", "at", "image"}, {}};
    for (const Json& row : document["structures"]) {
        table.rows.push_back({row["structure"], number_cell(row["sum"].get<double>(), 12),
                              number_cell(row["mean"].get<double>()),
                              number_cell(row["largest"].get<double>()), row["largest_at"].dump(),
                              row["image"]});
    }
    const bool timed = document["quantity"] == "time";
    return document["unit"].get<std::string>() + " per pixel; one scale, 0 to " +
           number_cell(document["scale"]["high"].get<double>()) + " (colour_bar.png)\n\n" +
           to_text(table) +
           (timed
                ? "\nThe least of all rounds. Batches of one pixel are slower than full ones, and "
                  "each has two\nlooks at the clock in it.\n"
                : "");
}

Json heatmap_document(const HeatmapArguments& arguments, const Catalogue& catalogue) {
    require_valid(arguments, catalogue);
    HeatMaps heat{cost_named(arguments.quantity), {}, {}, {}};
    const Spacing spacing = parse_spacing(arguments.spacing);
    const Scene scene = load_scene(arguments.scene);
    const ImageFormat format = image_format(scene, arguments.size, arguments.spp);
    std::vector<std::unique_ptr<Accel>> accels;
    for (const std::string& spec : arguments.structures) {
        require_takes(catalogue, spec, scene);
        accels.push_back(build(catalogue, spec, build_input(scene, format)));
        heat.structures.push_back(accels.back()->spec());
    }
    fs::create_directories(arguments.out);  // before the long part, not after it
    const RenderSettings settings = settings_by_pixel(format);
    heat.maps = measure(scene, accels, settings, heat.cost, arguments.repetitions);
    heat.scale = common_scale(heat.maps, spacing);
    if (arguments.top) heat.scale.high = *arguments.top;
    return {{"schema", schema_version},
            {"document", "heatmap"},
            {"scene", scene.name},
            {"quantity", name_of(heat.cost)},
            {"unit", unit_of(heat.cost)},
            {"width", format.width},
            {"height", format.height},
            {"spp", format.spp},
            {"batch", settings.batch},
            {"repetitions", heat.cost == Cost::time ? Json(arguments.repetitions) : Json(nullptr)},
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
