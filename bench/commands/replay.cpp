#include "bench/replay/replay.h"
#include "bench/command_line.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/output/progress.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <ostream>

/// `rayshoot replay`: a published table, and what we count instead.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

struct ReplayArguments {
    std::string table, scene, published;
    bool json = false;
};

PublishedTable table_to_replay(const ReplayArguments& arguments) {
    const bool own = !arguments.published.empty();
    PublishedTable table =
        read_published(own ? arguments.published : "data/published/" + arguments.table + ".csv");
    if (arguments.scene.empty()) return table;
    std::erase_if(table.numbers,
                  [&](const PublishedNumber& n) { return n.scene != arguments.scene; });
    if (table.numbers.empty())
        throw std::invalid_argument(table.path.string() + " has no numbers of the scene \"" +
                                    arguments.scene + "\"");
    return table;
}

/// Relative to the published number; "" where that is 0.
std::string difference(const ReplayedNumber& number) {
    if (number.published.value == 0) return "";
    char text[32];
    const double share = (number.ours - number.published.value) / number.published.value;
    std::snprintf(text, sizeof text, "%+.2f%%", 100 * share);
    return text;
}

Json to_json(const ReplayedNumber& number) {
    const PublishedNumber& published = number.published;
    return {{"structure", published.structure},
            {"setting", published.setting},
            {"scene", published.scene},
            {"metric", published.metric},
            {"published", published.value},
            {"ours", number.ours},
            {"difference", number.ours - published.value},
            {"tolerance", published.tolerance ? Json(*published.tolerance) : Json(nullptr)},
            {"verdict", verdict_name(number.verdict)},
            {"measure", published.measure},
            {"spec", published.spec}};
}

Table to_table(const std::vector<ReplayedNumber>& numbers) {
    Table table{
        {"structure", "setting", "scene", "metric", "published", "ours", "difference", "verdict"},
        {}};
    for (const ReplayedNumber& number : numbers) {
        const PublishedNumber& published = number.published;
        table.rows.push_back({published.structure, published.setting, published.scene,
                              published.metric, number_cell(published.value, 6),
                              number_cell(number.ours, 6), difference(number),
                              std::string(verdict_name(number.verdict))});
    }
    return table;
}

std::string summary(const std::vector<ReplayedNumber>& numbers) {
    std::string text = std::to_string(numbers.size()) + " numbers:";
    for (const ReplayVerdict verdict :
         {ReplayVerdict::exact, ReplayVerdict::within, ReplayVerdict::pinned, ReplayVerdict::open,
          ReplayVerdict::off, ReplayVerdict::changed}) {
        const auto count = std::count_if(numbers.begin(), numbers.end(), [&](const auto& number) {
            return number.verdict == verdict;
        });
        if (count > 0)
            text += " " + std::to_string(count) + " " + std::string(verdict_name(verdict)) + ",";
    }
    text.back() = '\n';
    return text;
}

int replay_table(const ReplayArguments& arguments, const Invocation& invocation) {
    const PublishedTable table = table_to_replay(arguments);
    Progress progress(rebuilds(table));
    const std::vector<ReplayedNumber> numbers =
        replay(invocation.catalogue, table, [&](const std::string& scene, const std::string& spec) {
            progress.advance(scene + " " + spec);
        });
    if (arguments.json) {
        Json document{{"schema", schema_version},
                      {"published", table.path.string()},
                      {"numbers", Json::array()}};
        for (const ReplayedNumber& number : numbers) document["numbers"].push_back(to_json(number));
        print_json(invocation.out, document);
    } else {
        invocation.out << to_text(to_table(numbers)) << summary(numbers);
    }
    const bool broken = std::any_of(numbers.begin(), numbers.end(),
                                    [](const auto& number) { return is_broken(number.verdict); });
    return broken ? exit_differences : exit_ok;
}

}  // namespace

void add_replay(CLI::App& app, Invocation& invocation) {
    auto arguments = std::make_shared<ReplayArguments>();
    CLI::App* command = app.add_subcommand("replay", "Rebuild a published table, ours beside it");
    command->add_option("table", arguments->table, "havran99")
        ->required()
        ->check(CLI::IsMember({"havran99"}));
    command->add_option("--scene", arguments->scene, "Only the numbers of this scene");
    command->add_option("--published", arguments->published, "Another table of the same form");
    command->add_flag("--json", arguments->json, "One JSON document on standard output");
    command->callback([arguments, &invocation] {
        invocation.chosen = [arguments, &invocation] {
            return replay_table(*arguments, invocation);
        };
    });
}

}  // namespace rayshoot
