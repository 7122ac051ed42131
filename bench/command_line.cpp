#include "bench/command_line.h"

#include "bench/commands/command.h"
#include "version/version.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <new>

namespace rayshoot {
namespace {

int execute(const Catalogue& catalogue, int argc, const char* const* argv, std::ostream& out,
            std::ostream& err) {
    CLI::App app(
        "Compares acceleration structures for ray tracing: same answers, exact counts, "
        "fair times.",
        "rayshoot");
    app.require_subcommand(1);
    app.set_version_flag("--version", [] { return describe(version()); });
    Invocation invocation{catalogue, out, err, {}};
    add_list(app, invocation);
    add_count(app, invocation);
    add_check(app, invocation);
    add_render(app, invocation);
    add_heatmap(app, invocation);
    add_difference(app, invocation);
    add_rays(app, invocation);
    add_bench(app, invocation);
    add_limits(app, invocation);
    add_scaling(app, invocation);
    add_report(app, invocation);
    add_replay(app, invocation);
    add_seed_question(app, invocation);
    add_textbook(app, invocation);
    add_gallery(app, invocation);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        return app.exit(wrong, out, err) == 0 ? exit_ok : exit_bad_input;
    }
    return invocation.chosen();
}

}  // namespace

int run(const Catalogue& catalogue, int argc, const char* const* argv) {
    return run(catalogue, argc, argv, std::cout, std::cerr);
}

int run(const Catalogue& catalogue, int argc, const char* const* argv, std::ostream& out,
        std::ostream& err) {
    try {
        const int code = execute(catalogue, argc, argv, out, err);
        out.flush();
        if (out) return code;
        err << "rayshoot: standard output cannot be written\n";
    } catch (const std::bad_alloc&) {
        err << "rayshoot: out of memory; take a smaller scene, --size or --spp\n";
    } catch (const std::exception& failure) {
        err << "rayshoot: " << failure.what() << "\n";
    }
    return exit_bad_input;
}

}  // namespace rayshoot
