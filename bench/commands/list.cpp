#include "accel/core/options.h"
#include "bench/commands/arguments.h"
#include "bench/commands/command.h"
#include "bench/comparison/document.h"
#include "bench/comparison/specimen.h"
#include "data/scenes.h"

#include <CLI/CLI.hpp>

#include <ostream>

/// `rayshoot list`: the structures and scenes there are.
namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

bool serves_any(const Accel& accel, RayKind kind) {
    return accel.serves(Query::closest, kind) || accel.serves(Query::occluded, kind);
}

Json serves(const StructureEntry& entry, const Specimen& specimen) {
    const Options defaults(entry.name, entry.options, "");
    const auto accel = entry.build(specimen.input(), defaults, std::string(entry.name));
    Json kinds = Json::array();
    if (serves_any(*accel, RayKind::camera)) kinds.push_back("camera");
    if (serves_any(*accel, RayKind::shadow)) kinds.push_back("shadow");
    if (serves_any(*accel, RayKind::secondary)) kinds.push_back("secondary");
    return kinds;
}

Json structure_to_json(const StructureEntry& entry, const Specimen& specimen) {
    Json options = Json::array();
    for (const OptionInfo& option : entry.options) {
        options.push_back({{"name", option.name},
                           {"values", option.values},
                           {"default", option.fallback},
                           {"meaning", option.meaning}});
    }
    return {{"name", entry.name},
            {"agreement", entry.agreement == Agreement::exact ? "exact" : "tolerance"},
            {"complete", entry.complete},
            {"remembers", entry.remembers},
            {"serves", serves(entry, specimen)},
            {"options", options},
            {"configurations", entry.configurations},
            {"summary", entry.summary}};
}

Json scenes_to_json() {
    Json scenes = Json::array();
    for (const SceneInfo& scene : list_scenes()) {
        scenes.push_back({{"name", scene.name},
                          {"options", scene.options},
                          {"summary", scene.summary},
                          {"available", scene.available},
                          {"command", scene.available ? Json(nullptr) : Json(scene.command)}});
    }
    return scenes;
}

Table scene_table(const Json& document) {
    Table table{{"scene", "what it is"}, {}};
    for (const Json& scene : document["scenes"]) {
        std::string summary = scene["summary"];
        if (!scene["options"].get<std::string>().empty()) {
            summary += "; options: " + scene["options"].get<std::string>();
        }
        if (!scene["available"]) summary += "; not here: " + scene["command"].get<std::string>();
        table.rows.push_back({scene["name"], summary});
    }
    return table;
}

Json list_document(const Catalogue& catalogue) {
    const Specimen specimen;
    Json document;
    document["schema"] = schema_version;
    document["structures"] = Json::array();
    for (const StructureEntry& entry : catalogue) {
        document["structures"].push_back(structure_to_json(entry, specimen));
    }
    document["scenes"] = scenes_to_json();
    return document;
}

Table structure_table(const Json& document) {
    Table table{{"structure", "agreement", "serves", "what it is"}, {}};
    for (const Json& entry : document["structures"]) {
        std::string kinds;
        for (const Json& kind : entry["serves"]) {
            kinds += (kinds.empty() ? "" : " ") + kind.get<std::string>();
        }
        table.rows.push_back({entry["name"], entry["agreement"], kinds, entry["summary"]});
        for (const Json& option : entry["options"]) {
            table.rows.push_back({"  " + option["name"].get<std::string>() + "=" +
                                      option["default"].get<std::string>(),
                                  "", "",
                                  option["values"].get<std::string>() + ": " +
                                      option["meaning"].get<std::string>()});
        }
    }
    return table;
}

}  // namespace

void add_list(CLI::App& app, Invocation& invocation) {
    auto json = std::make_shared<bool>(false);
    CLI::App* command = app.add_subcommand("list", "List structures, their options, and scenes");
    command->add_flag("--json", *json, "One JSON document on standard output");
    command->callback([json, &invocation] {
        invocation.chosen = [json, &invocation] {
            const Json document = list_document(invocation.catalogue);
            if (*json) {
                print_json(invocation.out, document);
            } else {
                invocation.out << to_text(structure_table(document)) << '\n'
                               << to_text(scene_table(document));
            }
            return 0;
        };
    });
}

}  // namespace rayshoot
