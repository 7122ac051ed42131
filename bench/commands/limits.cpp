#include "bench/limits/limits.h"

#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/output/machine.h"
#include "bench/output/whole_file.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot limits`: what the machine allows, and how much of it is reached.
namespace rayshoot {
namespace {

constexpr int most_mebibytes = 1 << 14;

struct LimitsArguments {
    std::vector<std::string> scenes, structures;
    std::vector<std::string> kinds{"camera", "shadow", "diffuse", "random"};
    std::string size = "384x384", out;
    LimitsPlan plan;  ///< for the defaults of its specs
    int threads = 1, repetitions = 11, largest = 1024;
    bool json = false;
};

/// The fastest of ours, and Embree in a build that has it.
std::vector<std::string> usual_structures(const Catalogue& catalogue) {
    std::vector<std::string> structures;
    for (const StructureEntry& entry : catalogue) {
        if (entry.name == "bvh8" || entry.name == "embree") structures.emplace_back(entry.name);
    }
    return structures;
}

std::size_t working_set(int mebibytes) {
    if (mebibytes >= 1 && mebibytes <= most_mebibytes)
        return static_cast<std::size_t>(mebibytes) << 20;
    throw std::invalid_argument("--largest takes 1 to " + std::to_string(most_mebibytes) +
                                " MiB, not " + std::to_string(mebibytes));
}

LimitsPlan plan_of(const LimitsArguments& arguments, const Catalogue& catalogue) {
    LimitsPlan plan = arguments.plan;
    plan.largest = working_set(arguments.largest);
    ComparisonPlan& comparison = plan.comparison;
    comparison.scenes = arguments.scenes;
    comparison.structures =
        arguments.structures.empty() ? usual_structures(catalogue) : arguments.structures;
    comparison.kinds.clear();
    for (const std::string& kind : arguments.kinds) comparison.kinds.push_back(stream_kind(kind));
    comparison.format = stream_format(arguments.size, 1);
    comparison.threads = require_threads(arguments.threads);
    comparison.gate_threads = processor_count();
    comparison.repetitions = arguments.repetitions;
    comparison.builds = 1;
    require_valid(catalogue, comparison);
    return plan;
}

int limits(const LimitsArguments& arguments, const Invocation& invocation) {
    if (!arguments.out.empty()) require_writable_file(arguments.out);
    const LimitsPlan plan = plan_of(arguments, invocation.catalogue);
    const Limits measured = measure_limits(invocation.catalogue, plan);
    const nlohmann::ordered_json document = to_document(plan, measured);
    if (!arguments.out.empty()) write_whole_file(arguments.out, document.dump(2) + "\n");
    if (arguments.json) print_json(invocation.out, document);
    else invocation.out << limits_text(document);
    return measured.comparison.failed() ? exit_differences : exit_ok;
}

void add_options(CLI::App& command, LimitsArguments& arguments) {
    command.add_option("--scene", arguments.scenes, "Scene strings or files")->required();
    command.add_option("--structure", arguments.structures,
                       "Specs held against the bounds; default: bvh8, and embree where there is");
    command.add_option("--alone", arguments.plan.alone,
                       "Spec that takes one ray at a time (" + arguments.plan.alone + ")");
    command.add_option("--in-flight", arguments.plan.in_flight,
                       "Spec with several rays in flight (" + arguments.plan.in_flight + ")");
    command.add_option("--rays", arguments.kinds, "camera,shadow,diffuse,random,mirror")
        ->delimiter(',');
    command.add_option("--size", arguments.size,
                       "WxH of the image rays are recorded from (384x384)");
    command.add_option("--threads", arguments.threads, "Threads of what is timed (1)");
    command.add_option("--repetitions", arguments.repetitions,
                       "Blocks of every structure once (11)");
    command.add_option("--largest", arguments.largest,
                       "MiB of the largest working set that memory is timed on (1024)");
    command.add_option("--out", arguments.out, "Write everything to this JSON file");
    command.add_flag("--json", arguments.json, "One JSON document on standard output");
}

}  // namespace

void add_limits(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<LimitsArguments>();
    CLI::App* command = app.add_subcommand(
        "limits", "How fast rays could be answered on this machine, and how much of it is reached");
    add_options(*command, *arguments);
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return limits(*arguments, invocation); };
    });
}

}  // namespace rayshoot
