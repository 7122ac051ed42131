#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/standard.h"
#include "bench/output/machine.h"
#include "data/scenes.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <ostream>

/// `rayshoot seed-question`: a hundred thousand objects, a million rays, 10^11 tests. What does
/// each structure save?
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

struct SeedArguments {
    std::vector<std::string> scenes{"soup:count=100000", "spd/mount:size=8"};
    std::vector<std::string> structures;
    std::string size = "1000x1000";
    int threads = 1, repetitions = 3;
    bool json = false;
};

ComparisonPlan plan_of(const SeedArguments& arguments, const Catalogue& catalogue) {
    ComparisonPlan plan;
    plan.scenes = arguments.scenes;
    plan.structures =
        arguments.structures.empty() ? standard_structures(catalogue) : arguments.structures;
    plan.kinds = {StreamKind::camera};
    plan.format = stream_format(arguments.size, 1);
    plan.threads = require_threads(arguments.threads);
    plan.gate_threads = processor_count();
    plan.repetitions = arguments.repetitions;
    require_valid(catalogue, plan);
    return plan;
}

/// For all rays of the image; measured on fewer, and multiplied, where the row was sampled.
Json answer(const Row& row) {
    const bool counted = row.counts && row.counts->available;
    const bool timed = row.mrays_per_second.has_value();
    const double share = static_cast<double>(row.rays) / static_cast<double>(row.timed_rays);
    Json tests = nullptr, volume_tests = nullptr, seconds = nullptr;
    if (counted) {
        const auto scaled = [&](Event event) {
            return std::llround(share * static_cast<double>(row.counts->total[event]));
        };
        tests = scaled(Event::object_test);
        volume_tests = scaled(Event::bounding_volume_test);
    }
    if (timed) {
        seconds = 1e-6 * static_cast<double>(row.rays) / row.mrays_per_second->median;
    }
    return {{"scene", row.name.scene},
            {"structure", row.name.spec},
            {"primitives", row.primitives},
            {"rays", row.rays},
            {"measured_rays", timed ? Json(row.timed_rays) : Json(nullptr)},
            {"extrapolated", row.sampled()},
            {"object_tests", tests},
            {"bounding_volume_tests", volume_tests},
            {"seconds", seconds},
            {"build_seconds",
             row.build_samples.empty() ? Json(nullptr) : Json(median(row.build_samples))},
            {"refusal", row.refusal.empty() ? Json(nullptr) : Json(row.refusal)},
            {"error", row.error.empty() ? Json(nullptr) : Json(row.error)}};
}

std::string cell(const Json& value, int digits) {
    return number_cell(value.is_number() ? std::optional(value.get<double>()) : std::nullopt,
                       digits);
}

std::string count_cell(const Json& value) { return value.is_null() ? not_measured : value.dump(); }

std::string how_measured(const Json& row) {
    if (row["error"].is_string()) return "error: " + row["error"].get<std::string>();
    if (row["refusal"].is_string()) return row["refusal"];
    if (!row["extrapolated"].get<bool>()) return "all rays";
    return "extrapolated from " + row["measured_rays"].dump() + " rays";
}

Table answer_table(const Json& document) {
    Table table{{"scene", "structure", "objects", "rays", "object tests", "volume tests", "seconds",
                 "build s", "measured on"},
                {}};
    for (const Json& row : document["rows"]) {
        table.rows.push_back({row["scene"], row["structure"], row["primitives"].dump(),
                              row["rays"].dump(), count_cell(row["object_tests"]),
                              count_cell(row["bounding_volume_tests"]), cell(row["seconds"], 3),
                              cell(row["build_seconds"], 3), how_measured(row)});
    }
    return table;
}

int seed_question(const SeedArguments& arguments, const Invocation& invocation) {
    const ComparisonPlan plan = plan_of(arguments, invocation.catalogue);
    const Comparison comparison = compare(invocation.catalogue, plan);
    Json document{{"schema", schema_version},
                  {"document", "seed-question"},
                  {"provenance", provenance()},
                  {"threads", plan.threads},
                  {"rows", Json::array()}};
    for (const Row& row : comparison.rows) document["rows"].push_back(answer(row));
    if (arguments.json) {
        print_json(invocation.out, document);
    } else {
        invocation.out << "One image of " << plan.format.width << " x " << plan.format.height
                       << " rays, " << plan.threads << " thread(s):\n\n"
                       << to_text(answer_table(document));
    }
    return comparison.failed() ? exit_differences : exit_ok;
}

}  // namespace

void add_seed_question(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<SeedArguments>();
    CLI::App* command = app.add_subcommand(
        "seed-question", "100,000 objects, a million rays: what does each structure save?");
    command->add_option("--scene", arguments->scenes,
                        "Scenes (soup:count=100000, "
                        "spd/mount:size=8)");
    command->add_option("--structure", arguments->structures, "Structure specs; default: all");
    command->add_option("--size", arguments->size, "WxH (1000x1000)");
    command->add_option("--threads", arguments->threads, "Threads (1)");
    command->add_option("--repetitions", arguments->repetitions, "Repetitions (3)");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] {
            return seed_question(*arguments, invocation);
        };
    });
}

}  // namespace rayshoot
