#include "bench/programs/program.h"

#include "bench/command_line.h"
#include "bench/comparison/row_name.h"
#include "bench/programs/row_reporter.h"

#include <CLI/CLI.hpp>

#include <iostream>

namespace rayshoot {
namespace {

struct ProgramOptions {
    PlanOptions plan;
    std::vector<std::string> rest;  ///< for Google Benchmark
    bool json = false;
    bool to_file = false;  ///< --benchmark_out was given
};

/// A row of build or render names no kind, so it narrows the plan by itself.
void narrow_to_kindless_rows(const std::string& family, ProgramOptions& options,
                             ComparisonPlan& plan) {
    plan.scenes.clear();
    plan.structures.clear();
    for (const std::string& text : options.plan.rows) {
        const RowName name = parse_row_name(text);
        if (name.family != family) {
            throw std::invalid_argument("\"" + text + "\" is no row of bench_" + family);
        }
        plan.scenes.push_back(name.scene);
        plan.structures.push_back(name.spec);
        plan.rows.insert(text);
    }
    for (auto* list : {&plan.scenes, &plan.structures}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
    }
}

ComparisonPlan plan_of(const std::string& family, const Catalogue& catalogue,
                       ProgramOptions& options) {
    if (options.plan.scenes.empty() && options.plan.rows.empty()) options.plan.standard = true;
    if (family == "rays" || options.plan.rows.empty()) return make_plan(catalogue, options.plan);
    PlanOptions without_rows = options.plan;
    without_rows.rows.clear();
    without_rows.standard = true;
    ComparisonPlan plan = make_plan(catalogue, without_rows);
    narrow_to_kindless_rows(family, options, plan);
    require_valid(catalogue, plan);
    return plan;
}

/// Google Benchmark prints to standard output what it does not know, and goes on; we do not.
void initialise(const std::string& program, const ProgramOptions& options) {
    std::vector<std::string> texts{program};
    texts.insert(texts.end(), options.rest.begin(), options.rest.end());
    const std::string repetitions =
        "--benchmark_repetitions=" +
        std::to_string(options.plan.repetitions.value_or(default_repetitions));
    texts.insert(texts.begin() + 1, {repetitions, "--benchmark_enable_random_interleaving=true"});
    std::vector<char*> arguments;
    for (std::string& text : texts) arguments.push_back(text.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (count > 1) throw std::invalid_argument(std::string("unknown option ") + arguments[1]);
}

int measure(const ProgramOptions& options) {
    const auto form = options.json ? RowReporter::Form::json : RowReporter::Form::text;
    RowReporter screen(form);
    RowReporter file(RowReporter::Form::json);
    const std::size_t run = options.to_file ? benchmark::RunSpecifiedBenchmarks(&screen, &file)
                                            : benchmark::RunSpecifiedBenchmarks(&screen);
    benchmark::Shutdown();
    if (run == 0) throw std::invalid_argument("no row matches");
    return screen.failed() ? exit_differences : exit_ok;
}

int run_unguarded(const std::string& family, const RegisterCases& register_cases, int argc,
                  char** argv) {
    CLI::App app("Times rows " + family + "/...; takes Google Benchmark's options as well",
                 "bench_" + family);
    ProgramOptions options;
    add_plan_options(app, options.plan);
    app.add_flag("--json", options.json, "One JSON document on standard output");
    app.allow_extras();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        return app.exit(wrong) == 0 ? exit_ok : exit_bad_input;
    }
    options.rest = app.remaining();
    for (const std::string& text : options.rest) {
        options.to_file = options.to_file || text.starts_with("--benchmark_out=");
    }
    initialise("bench_" + family, options);
    const Catalogue catalogue = built_in_catalogue();
    register_cases(catalogue, plan_of(family, catalogue, options));
    return measure(options);
}

}  // namespace

int run_program(const std::string& family, const RegisterCases& register_cases, int argc,
                char** argv) {
    try {
        return run_unguarded(family, register_cases, argc, argv);
    } catch (const std::exception& failure) {
        std::cerr << "bench_" << family << ": " << failure.what() << '\n';
        return exit_bad_input;
    }
}

}  // namespace rayshoot
