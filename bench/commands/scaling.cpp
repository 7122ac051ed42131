#include "bench/scaling/scaling.h"

#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/output/machine.h"
#include "bench/output/whole_file.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot scaling`: how costs grow with the number of primitives.
namespace rayshoot {
namespace {

struct ScalingArguments {
    std::vector<std::string> structures, kinds{"camera", "random"};
    std::string size = "256x256", out;
    ScalingPlan plan;  ///< for its families and sizes
    int threads = 1, repetitions = 5, builds = 1;
    bool json = false;
};

ScalingPlan plan_of(const ScalingArguments& arguments, const Catalogue& catalogue) {
    ScalingPlan plan = arguments.plan;
    choose_scenes(plan);
    ComparisonPlan& comparison = plan.comparison;
    comparison.structures = arguments.structures;
    comparison.kinds.clear();
    for (const std::string& kind : arguments.kinds) comparison.kinds.push_back(stream_kind(kind));
    comparison.format = stream_format(arguments.size, 1);
    comparison.threads = require_threads(arguments.threads);
    comparison.gate_threads = processor_count();
    comparison.repetitions = arguments.repetitions;
    comparison.builds = arguments.builds;
    require_valid(catalogue, comparison);
    return plan;
}

int scaling(const ScalingArguments& arguments, const Invocation& invocation) {
    if (!arguments.out.empty()) require_writable_file(arguments.out);
    const ScalingPlan plan = plan_of(arguments, invocation.catalogue);
    const Comparison comparison = compare(invocation.catalogue, plan.comparison);
    const nlohmann::ordered_json document = to_document(plan, comparison);
    if (!arguments.out.empty()) write_whole_file(arguments.out, document.dump(2) + "\n");
    if (arguments.json) print_json(invocation.out, document);
    else invocation.out << scaling_text(document);
    return comparison.failed() ? exit_differences : exit_ok;
}

void add_options(CLI::App& command, ScalingArguments& arguments) {
    command.add_option("--structure", arguments.structures, "Specs")->required();
    command
        .add_option("--family", arguments.plan.families, "tetra, balls, soup; default: all of them")
        ->delimiter(',');
    command.add_option("--most", arguments.plan.most, "Primitives of the largest scene (1.1e6)");
    command.add_option("--rays", arguments.kinds, "camera,shadow,diffuse,random,mirror")
        ->delimiter(',');
    command.add_option("--size", arguments.size,
                       "WxH of the image rays are recorded from (256x256)");
    command.add_option("--threads", arguments.threads, "Threads of what is timed (1)");
    command.add_option("--repetitions", arguments.repetitions,
                       "Blocks of every structure once (5)");
    command.add_option("--builds", arguments.builds, "Builds of each structure, at least (1)");
    command.add_option("--out", arguments.out, "Write everything to this JSON file");
    command.add_flag("--json", arguments.json, "One JSON document on standard output");
}

}  // namespace

void add_scaling(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<ScalingArguments>();
    CLI::App* command = app.add_subcommand(
        "scaling", "How build time, memory and time per ray grow with the number of primitives");
    add_options(*command, *arguments);
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return scaling(*arguments, invocation); };
    });
}

}  // namespace rayshoot
