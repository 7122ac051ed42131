#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/commands/plan_options.h"
#include "bench/comparison/results.h"
#include "bench/comparison/summary.h"
#include "bench/output/whole_file.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <ostream>

/// `rayshoot bench`: the comparison of structures on recorded rays.
namespace rayshoot {
namespace {

struct BenchArguments {
    PlanOptions plan;
    std::string out, results;
    double void_above = 5;  ///< percent
    int builds = 3;
    bool json = false;
};

double share_of(double percent) {
    if (percent > 0 && std::isfinite(percent)) return 0.01 * percent;
    throw std::invalid_argument("--void-above takes a percentage above 0, not " +
                                number_cell(percent));
}

std::string summary_text(const nlohmann::ordered_json& document) {
    const Table table = summary_table(document);
    if (table.rows.empty()) return "";
    return "\nover Embree's best path, geometric means over scenes:\n" + to_text(table) +
           below_embree_text(document) + "\n";
}

int bench(const BenchArguments& arguments, const Invocation& invocation) {
    if (!arguments.out.empty()) require_writable_file(arguments.out);
    if (!arguments.results.empty()) require_results_root(arguments.results);
    ComparisonPlan plan = make_plan(invocation.catalogue, arguments.plan);
    plan.void_above = share_of(arguments.void_above);
    plan.builds = arguments.builds;
    require_valid(invocation.catalogue, plan);
    const Comparison comparison = compare(invocation.catalogue, plan);
    const nlohmann::ordered_json document = to_document(plan, comparison);
    if (!arguments.out.empty()) write_whole_file(arguments.out, document.dump(2) + "\n");
    if (arguments.json) {
        print_json(invocation.out, document);
    } else {
        invocation.out << to_text(comparison_table(document)) << summary_text(document)
                       << notes(document);
    }
    if (!arguments.results.empty()) {
        const std::string folder = write_results(arguments.results, document);
        if (!arguments.json) invocation.out << "written to " << folder << '\n';
    }
    return comparison.failed() ? exit_differences : exit_ok;
}

}  // namespace

void add_bench(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<BenchArguments>();
    CLI::App* command = app.add_subcommand("bench", "Compare structures on recorded rays");
    add_plan_options(*command, arguments->plan);
    command->add_option(
        "--protocol", arguments->plan.protocol,
        "What is not given by other options is this protocol's. speed: bvh8 "
        "against all of Embree's paths and build qualities on six scenes, "
        "1024x1024, in 15 blocks; once for each number of threads, in a process of its own. "
        "subdivision: grid, octree and bsp likewise, 512x512");
    command->add_option("--builds", arguments->builds,
                        "Builds of each structure, in turns, at least (3)");
    command->add_option("--void-above", arguments->void_above,
                        "A run is marked void when the control kernel moved by more percent (5)");
    command->add_option("--out", arguments->out, "Write the raw results to this JSON file");
    command->add_option(
        "--results", arguments->results,
        "Write raw results and tables to a folder <date>-<processor> in this one; of a "
        "protocol: <date>-<processor>-<protocol>-threads-<threads>");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return bench(*arguments, invocation); };
    });
}

}  // namespace rayshoot
