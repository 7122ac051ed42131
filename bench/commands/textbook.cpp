#include "bench/textbook/textbook.h"
#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/output/machine.h"
#include "bench/output/progress.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <ostream>

/// `rayshoot textbook`: the book's figures and tables, each with its check.
namespace rayshoot {
namespace {

struct TextbookArguments {
    std::string out;
    std::vector<std::string> figures;
    int edge = 256;
    int threads = processor_count();
    bool list = false, json = false;
};

Table figure_table() {
    Table table{{"figure", "shows"}, {}};
    for (const textbook::Figure& figure : textbook::figures())
        table.rows.push_back({std::string(figure.name), std::string(figure.shows)});
    return table;
}

void require_valid(const TextbookArguments& arguments) {
    if (arguments.out.empty())
        throw std::invalid_argument("--out is needed: the folder that the figures go into");
    if (arguments.edge < textbook::smallest_edge || arguments.edge > textbook::largest_edge)
        throw std::invalid_argument("--size " + std::to_string(arguments.edge) +
                                    ": a picture's edge is " +
                                    std::to_string(textbook::smallest_edge) + " to " +
                                    std::to_string(textbook::largest_edge) + " pixels");
}

std::string summary(std::span<const textbook::FinishedFigure> finished) {
    std::size_t checks = 0, misprints = 0, failed = 0;
    for (const textbook::FinishedFigure& one : finished) {
        for (const textbook::Check& check : one.sheet.checks()) {
            ++checks;
            misprints += check.verdict == textbook::Verdict::misprint;
            failed += check.verdict == textbook::Verdict::off;
        }
    }
    return "\n" + std::to_string(checks) + " checks: " + std::to_string(failed) + " failed, " +
           std::to_string(misprints) + " known misprints\n";
}

int make_textbook(const TextbookArguments& arguments, const Invocation& invocation) {
    if (arguments.list) {
        invocation.out << to_text(figure_table());
        return exit_ok;
    }
    require_valid(arguments);
    const auto chosen = textbook::chosen_figures(arguments.figures);
    const textbook::Studio studio{invocation.catalogue, arguments.edge,
                                  require_threads(arguments.threads)};
    const std::filesystem::path folder = arguments.out;
    std::filesystem::create_directories(folder);
    Progress progress(chosen.size());
    const auto finished = textbook::make_figures(
        studio, chosen, folder, [&](const std::string& name) { progress.advance(name); });
    textbook::write_page(finished, folder);
    if (arguments.json) {
        print_json(invocation.out, {{"schema", schema_version},
                                    {"document", "textbook"},
                                    {"figures", textbook::to_json(finished)}});
    } else {
        invocation.out << to_text(textbook::check_table(finished)) << summary(finished);
    }
    return textbook::all_hold(finished) ? exit_ok : exit_differences;
}

}  // namespace

void add_textbook(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<TextbookArguments>();
    CLI::App* command =
        app.add_subcommand("textbook", "The textbook's figures and tables, each with its check");
    command->add_option("--out", arguments->out, "Folder for pictures, curves and README.md");
    command->add_option("--figure", arguments->figures, "Names; default: all of them");
    command->add_option("--size", arguments->edge, "Edge of a picture in pixels (256)");
    command->add_option("--threads", arguments->threads, "Threads of what is not timed (all)");
    command->add_flag("--list", arguments->list, "Only say which figures there are");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] {
            return make_textbook(*arguments, invocation);
        };
    });
}

}  // namespace rayshoot
