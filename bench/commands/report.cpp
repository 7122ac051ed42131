#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/results.h"
#include "data/file.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot report`: tables from the raw results of `rayshoot bench`.
namespace rayshoot {
namespace {

struct ReportArguments {
    std::string raw, out;
    std::string form = "text";
    bool json = false;
};

nlohmann::ordered_json read_raw(const std::string& path) {
    try {
        nlohmann::ordered_json document = nlohmann::ordered_json::parse(read_file(path));
        require_comparison(document);
        return document;
    } catch (const nlohmann::json::exception& wrong) {
        throw std::invalid_argument(path + ": no JSON: " + wrong.what());
    } catch (const std::invalid_argument& wrong) {
        const std::string text = wrong.what();
        throw std::invalid_argument(text.starts_with(path) ? text : path + ": " + text);
    }
}

std::string as_form(const Table& table, const std::string& form) {
    if (form == "text") return to_text(table);
    if (form == "markdown") return to_markdown(table);
    if (form == "csv") return to_csv(table);
    throw std::invalid_argument("unknown form \"" + form + "\"; there are text, markdown and csv");
}

int report(const ReportArguments& arguments, const Invocation& invocation) {
    const auto document = read_raw(arguments.raw);
    const std::string table = as_form(comparison_table(document), arguments.form);
    if (!arguments.out.empty()) {
        require_results_root(arguments.out);
        write_tables(arguments.out, document);
    }
    if (arguments.json) print_json(invocation.out, document);
    else invocation.out << table << (arguments.form == "text" ? notes(document) : "");
    return 0;
}

}  // namespace

void add_report(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<ReportArguments>();
    CLI::App* command = app.add_subcommand("report", "Make tables from raw results");
    command->add_option("raw", arguments->raw, "JSON file of `rayshoot bench --out`")->required();
    command->add_option("--out", arguments->out, "Write Markdown and CSV tables to this folder");
    command->add_option("--form", arguments->form, "text, markdown or csv");
    command->add_flag("--json", arguments->json, "The document itself on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] { return report(*arguments, invocation); };
    });
}

}  // namespace rayshoot
