#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "bench/gate/tolerance.h"
#include "bench/streams/promises.h"
#include "bench/streams/random_rays.h"
#include "bench/streams/ray_file.h"
#include "bench/streams/record.h"
#include "data/scenes.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot check`: a structure against brute force, on random rays or on a file of them.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_rays = std::size_t{1} << 24;  // 1 GB of rays and answers

struct CheckArguments {
    std::string scene, structure, rays_file;
    long long rays = 10000;
    std::uint64_t seed = 1;
    int threads = 1;
    bool json = false;
};

struct Findings {
    std::size_t declined = 0, ambiguous = 0;
    Differences differences;
};

/// One question of every ray, brute force against the structure.
Findings ask(const Accel& oracle, const Accel& accel, Agreement agreement, const Geometry& geometry,
             const RayStream& stream, TraceSettings settings) {
    StreamTracer expected(oracle, stream, settings);
    StreamTracer found(accel, stream, settings);
    expected.trace_fresh();
    found.trace_fresh();
    Findings findings;
    findings.declined = found.declined();
    if (agreement == Agreement::exact) {
        findings.differences = exact_differences(stream, expected.answers(), found.answers());
    } else {
        const ToleranceResult judged =
            tolerance_differences(oracle, geometry, stream, expected.answers(), found.answers());
        findings.ambiguous = judged.ambiguous;
        findings.differences = judged.unexplained;
    }
    return findings;
}

RayStream rays_to_check(const CheckArguments& arguments, const Scene& scene) {
    if (!arguments.rays_file.empty()) return read_ray_file(arguments.rays_file);
    if (arguments.rays < 1 || static_cast<std::size_t>(arguments.rays) > most_rays) {
        throw std::invalid_argument("--rays must be 1 to " + std::to_string(most_rays) + ", not " +
                                    std::to_string(arguments.rays));
    }
    return hostile_rays(scene.geometry, static_cast<std::size_t>(arguments.rays), arguments.seed);
}

Json to_json(const std::optional<Difference>& difference, const std::string& question) {
    if (!difference) return nullptr;
    return {{"ray", difference->ray},
            {"question", question},
            {"expected", difference->expected},
            {"found", difference->found},
            {"asked", difference->asked}};
}

Json check_document(const CheckArguments& arguments, const Catalogue& catalogue) {
    require_spec(catalogue, arguments.structure);
    const TraceSettings settings{require_threads(arguments.threads)};
    const Scene scene = load_scene(arguments.scene);
    require_takes(catalogue, arguments.structure, scene);
    RayStream stream = rays_to_check(arguments, scene);
    const BuildInput input = build_input(scene, format_of(stream, mesh_format));
    require_promises_kept(input, stream);
    const auto oracle = build(catalogue, oracle_spec, input);
    const auto accel = build(catalogue, arguments.structure, input);
    Json document{{"schema", schema_version}, {"scene", scene.name}, {"structure", accel->spec()}};
    std::size_t declined = 0, differences = 0, ambiguous = 0;
    Json first;
    for (const Query question : {Query::closest, Query::occluded}) {
        stream.question = question;
        const Findings found = ask(*oracle, *accel, agreement(catalogue, arguments.structure),
                                   scene.geometry, stream, settings);
        declined += found.declined;
        differences += found.differences.count;
        ambiguous += found.ambiguous;
        if (first.is_null()) {
            first = to_json(found.differences.first,
                            question == Query::closest ? "closest" : "occluded");
        }
    }
    document["rays"] = stream.size();
    document["seed"] = arguments.seed;
    document["declined"] = declined;
    document["ambiguous"] = ambiguous;
    document["differences"] = differences;
    document["first_difference"] = first;
    return document;
}

std::string sentence(const Json& document) {
    std::string text = document["structure"].get<std::string>() + " on " +
                       document["scene"].get<std::string>() + ": " + document["rays"].dump() +
                       " rays, both questions, " + document["differences"].dump() +
                       " differences, " + document["declined"].dump() + " declined, " +
                       document["ambiguous"].dump() + " ambiguous\n";
    const Json& first = document["first_difference"];
    if (first.is_null()) return text;
    return text + "first: ray " + first["ray"].dump() + " (" +
           first["question"].get<std::string>() + "), " + first["asked"].get<std::string>() +
           "\n  expected " + first["expected"].get<std::string>() + "\n  found    " +
           first["found"].get<std::string>() + "\n";
}

int check(const CheckArguments& arguments, const Invocation& invocation) {
    const Json document = check_document(arguments, invocation.catalogue);
    if (arguments.json) print_json(invocation.out, document);
    else invocation.out << sentence(document);
    const bool wrong = document["differences"] != 0 || document["declined"] != 0;
    return wrong ? exit_differences : exit_ok;
}

}  // namespace

void add_check(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<CheckArguments>();
    CLI::App* command = app.add_subcommand("check", "Compare a structure with brute force");
    command->add_option("--scene", arguments->scene, "Scene string or file")->required();
    command->add_option("--structure", arguments->structure, "Structure spec")->required();
    command->add_option("--rays", arguments->rays, "How many random rays (10000)");
    command->add_option("--seed", arguments->seed, "Seed of the random rays (1)");
    command->add_option("--rays-file", arguments->rays_file, "Rays of this file instead");
    command->add_option("--threads", arguments->threads, "Threads (1)");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return check(*arguments, invocation); };
    });
}

}  // namespace rayshoot
