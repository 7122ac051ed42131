#include "bench/commands/plan_options.h"

#include "bench/commands/arguments.h"
#include "bench/comparison/protocol.h"
#include "bench/comparison/standard.h"
#include "bench/output/machine.h"
#include "data/scenes.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>

namespace rayshoot {

void add_plan_options(CLI::App& command, PlanOptions& options) {
    command.add_option("--scene", options.scenes, "Scene strings or files");
    command.add_option("--structure", options.structures,
                       "Structure specs; default: all there are");
    command.add_option("--rays", options.kinds, "camera,shadow,diffuse,random,mirror")
        ->delimiter(',');
    command.add_option("--rays-file", options.ray_files, "Trace the rays of these files instead");
    command.add_option("--row", options.rows,
                       "Only this row, rays/<scene>/<structure>/<kind>; "
                       "exact, may be repeated");
    command.add_option("--size", options.size, "WxH of the image rays are recorded from (384x384)");
    command.add_option("--spp", options.spp, "Camera rays per pixel (1)");
    command.add_option("--threads", options.threads,
                       "Threads of what is timed, builds as well (1)");
    command.add_option("--repetitions", options.repetitions, "Blocks of every structure once (11)");
    command.add_option("--batch", options.batch, "Rays in a batch (1024)");
    command.add_option("--seed", options.seed, "Seed of samples and orders (1)");
    command.add_flag("--warm", options.warm, "Rows on sessions that are kept, as well");
    command.add_flag("--adaptor-cost", options.adaptor_cost,
                     "Measure what our interface costs Embree as well");
    command.add_flag("--standard", options.standard,
                     "The standard scenes, all structures, and --adaptor-cost");
}

namespace {

/// Before anything is measured, not when its turn comes.
void require_here(const std::vector<std::string>& scenes) {
    for (const SceneInfo& known : list_scenes()) {
        const auto asked = [&](const std::string& scene) {
            return scene.substr(0, scene.find(':')) == known.name;
        };
        if (known.available || std::ranges::none_of(scenes, asked)) continue;
        throw std::invalid_argument("the protocol needs " + known.name +
                                    "; to get it: " + known.command);
    }
}

/// What the options leave open is the protocol's; its yardsticks are always in.
void follow(const Protocol& protocol, const PlanOptions& options, ComparisonPlan& plan) {
    plan.protocol = protocol.name;
    if (options.scenes.empty()) plan.scenes = protocol.scenes;
    plan.structures = options.structures.empty() ? protocol.structures : options.structures;
    std::ranges::copy_if(
        protocol.yardsticks, std::back_inserter(plan.structures),
        [&](const std::string& spec) { return std::ranges::count(plan.structures, spec) == 0; });
    plan.format = stream_format(options.size.value_or(protocol.size), options.spp);
    require_here(plan.scenes);
    plan.repetitions = options.repetitions.value_or(protocol.least_repetitions);
    if (plan.repetitions >= protocol.least_repetitions) return;
    throw std::invalid_argument("the protocol \"" + protocol.name + "\" takes at least " +
                                std::to_string(protocol.least_repetitions) + " repetitions, not " +
                                std::to_string(plan.repetitions));
}

}  // namespace

ComparisonPlan make_plan(const Catalogue& catalogue, const PlanOptions& options) {
    ComparisonPlan plan;
    plan.scenes = options.scenes;
    plan.structures = options.structures;
    if (options.standard && plan.scenes.empty()) plan.scenes = standard_scenes();
    if (plan.structures.empty()) plan.structures = standard_structures(catalogue);
    plan.kinds.clear();
    for (const std::string& kind : options.kinds) plan.kinds.push_back(stream_kind(kind));
    plan.ray_files.assign(options.ray_files.begin(), options.ray_files.end());
    plan.format = stream_format(options.size.value_or(default_size), options.spp);
    plan.threads = require_threads(options.threads);
    plan.gate_threads = processor_count();
    plan.repetitions = options.repetitions.value_or(default_repetitions);
    plan.batch = options.batch;
    plan.seed = options.seed;
    plan.warm = options.warm;
    plan.adaptor_cost = options.adaptor_cost || options.standard;
    if (!options.protocol.empty()) follow(protocol(options.protocol), options, plan);
    narrow_to_rows(plan, options.rows);
    require_valid(catalogue, plan);
    return plan;
}

}  // namespace rayshoot
