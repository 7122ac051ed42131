#include "bench/comparison/cells.h"
#include "bench/comparison/document.h"
#include "bench/comparison/row_name.h"
#include "bench/statistics/estimate.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* sampled_mark = "*";  // measured on a sample of the stream
constexpr const char* failed_cell = "error";

/// All rows of one structure on one scene.
struct Group {
    std::string scene, structure;
    std::vector<const Json*> rows;

    const Json* row(const std::string& kind) const {
        for (const Json* row : rows) {
            if ((*row)["kind"] == kind) return row;
        }
        return nullptr;
    }
    /// The mean over all rays of all kinds, where every kind has one.
    std::optional<double> mean(const char* event) const {
        double sum = 0, rays = 0;
        for (const Json* row : rows) {
            const auto value = number(at(*row, {"per_ray", event}));
            const auto count = number(at(*row, {"rays"}));
            if (count == 0.0) continue;
            if (!value || !count) return std::nullopt;
            sum += *value * *count;
            rays += *count;
        }
        if (rays == 0) return std::nullopt;
        return sum / rays;
    }
};

std::vector<Group> groups_of(const Json& document) {
    std::vector<Group> groups;
    for (const Json& row : document["rows"]) {
        if (row.value("warm", false)) continue;
        const auto same = [&](const Group& group) {
            return row["scene"] == group.scene && row["structure"] == group.structure;
        };
        auto group = std::ranges::find_if(groups, same);
        if (group == groups.end()) {
            groups.push_back({row["scene"], row["structure"], {}});
            group = groups.end() - 1;
        }
        group->rows.push_back(&row);
    }
    return groups;
}

std::vector<std::string> kinds_of(const Json& document) {
    std::vector<std::string> kinds;
    for (const Json& row : document["rows"]) {
        if (std::ranges::find(kinds, row["kind"].get<std::string>()) == kinds.end())
            kinds.push_back(row["kind"]);
    }
    return kinds;
}

/// Marked where it was found on a sample of the stream.
std::string marked(std::string cell, const Json& row) {
    return row.value("sampled", false) && cell != not_measured ? cell + sampled_mark : cell;
}

std::string rate_cell(const Json* row, const char* what) {
    if (!row) return not_measured;
    if (at(*row, {"error"}).is_string()) return failed_cell;
    return marked(number_cell(number(at(*row, {what, "median"})), 3), *row);
}

std::string mean_cell(const Json& row, const char* event) {
    return marked(number_cell(number(at(row, {"per_ray", event}))), row);
}

std::optional<double> bytes_per_primitive(const Json& row, const char* key) {
    const auto bytes = number(at(row, {key}));
    const auto primitives = number(at(row, {"primitives"}));
    if (!bytes || !primitives || *primitives == 0) return std::nullopt;
    return *bytes / *primitives;
}

std::optional<double> milliseconds(const Json& value) {
    const auto seconds = number(value);
    return seconds ? std::optional(1e3 * *seconds) : std::nullopt;
}

std::string whole_cell(const Json& value) {
    return value.is_null() ? std::string(not_measured) : value.dump();
}

std::string text_cell(const Json& value) {
    return value.is_string() ? value.get<std::string>() : not_measured;
}

std::vector<std::string> detail_cells(const Json& row) {
    return {row["name"],
            whole_cell(at(row, {"rays"})),
            mean_cell(row, "object_tests"),
            mean_cell(row, "bounding_volume_tests"),
            mean_cell(row, "steps"),
            rate_cell(&row, "mrays_per_second"),
            interval_cell(row, "mrays_per_second"),
            rate_cell(&row, "ratio_to_embree"),
            interval_cell(row, "ratio_to_embree"),
            rate_cell(&row, "ratio_to_best_embree"),
            interval_cell(row, "ratio_to_best_embree"),
            text_cell(at(row, {"best_embree"}))};
}

std::string percent_cell(const Json& share) {
    const auto value = number(share);
    return number_cell(value ? std::optional(100 * *value) : std::nullopt, 3) + " %";
}

/// How still the machine held; nothing for a document of before this was kept.
std::string control_note(const Json& document) {
    const Json control = at(document, {"control"});
    if (!control.is_object()) return "";
    if (!number(control["moved"])) {
        return "control kernel: one block does not say whether the machine held still\n";
    }
    const bool is_void = control["void"] == true;
    return "control kernel: moved by " + percent_cell(control["moved"]) + " over " +
           control["blocks"].dump() + " blocks; a run is void above " +
           percent_cell(control["void_above"]) +
           (is_void ? ": this run is VOID, repeat it on a quiet machine\n"
                    : ": this one is valid\n");
}

/// More than one of Embree's rows, so that the best is worth a column of its own.
bool compares_embree_paths(const Json& document) {
    std::set<std::string> specs;
    for (const Json& row : document["rows"]) {
        if (is_embree(row["structure"].get<std::string>())) specs.insert(row["structure"]);
    }
    return specs.size() > 1;
}

/// The median over all paths and streams, and the worst of them by name.
std::string adaptor_note(const Json& document) {
    std::vector<double> ratios;
    std::string worst;
    for (const Json& row : at(document, {"embree_adaptor"})) {
        const auto ratio = number(at(row, {"adaptor_to_direct", "median"}));
        if (!ratio) continue;
        if (ratios.empty() || *ratio < *std::ranges::min_element(ratios))
            worst = row["scene"].get<std::string>() + ", " + row["kind"].get<std::string>() + ", " +
                    row["path"].get<std::string>();
        ratios.push_back(*ratio);
    }
    if (ratios.empty()) return "";
    return "Embree through our interface / called directly: median " +
           number_cell(median(ratios), 3) + ", lowest " +
           number_cell(*std::ranges::min_element(ratios), 3) + " (" + worst + ")\n";
}

}  // namespace

void require_comparison(const Json& document) {
    const auto missing = [](const std::string& what) {
        throw std::invalid_argument("no comparison as `rayshoot bench --out` writes it: " + what);
    };
    if (!document.is_object()) missing("it is no JSON object");
    if (document.value("schema", 0) != schema_version) missing("\"schema\" is not 1");
    if (!document.contains("rows") || !document["rows"].is_array()) missing("\"rows\" is missing");
    for (const Json& row : document["rows"]) {
        for (const char* key : {"name", "scene", "structure", "kind"}) {
            if (!at(row, {key}).is_string()) missing("a row without \"" + std::string(key) + "\"");
        }
    }
}

Table comparison_table(const Json& document) {
    require_comparison(document);
    const std::vector<std::string> kinds = kinds_of(document);
    Table table{{"scene", "structure", "build ms", "build Mprimitives/s", "peak bytes/primitive",
                 "bytes/primitive", "object tests/ray", "volume tests/ray", "steps/ray"},
                {}};
    for (const std::string& kind : kinds) table.headings.push_back(kind + " Mrays/s");
    std::vector<std::pair<const char*, const char*>> ratios{{" / Embree", "ratio_to_embree"}};
    if (compares_embree_paths(document))
        ratios.emplace_back(" / best Embree", "ratio_to_best_embree");
    for (const auto& [heading, key] : ratios) {
        for (const std::string& kind : kinds) table.headings.push_back(kind + heading);
    }
    for (const Group& group : groups_of(document)) {
        const Json& first = *group.rows.front();
        std::vector<std::string> cells{
            group.scene,
            group.structure,
            number_cell(milliseconds(at(first, {"build_seconds"})), 3),
            number_cell(number(at(first, {"build_mprimitives_per_second", "median"})), 3),
            number_cell(bytes_per_primitive(first, "build_peak_bytes"), 3),
            number_cell(bytes_per_primitive(first, "bytes"), 3),
            marked(number_cell(group.mean("object_tests")), first),
            marked(number_cell(group.mean("bounding_volume_tests")), first),
            marked(number_cell(group.mean("steps")), first)};
        for (const std::string& kind : kinds)
            cells.push_back(rate_cell(group.row(kind), "mrays_per_second"));
        for (const auto& [heading, key] : ratios) {
            for (const std::string& kind : kinds) cells.push_back(rate_cell(group.row(kind), key));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table detail_table(const Json& document) {
    require_comparison(document);
    Table table{{"row", "rays", "object tests/ray", "volume tests/ray", "steps/ray", "Mrays/s",
                 "95 % interval", "/ Embree", "95 % interval", "/ best Embree", "95 % interval",
                 "best Embree"},
                {}};
    for (const Json& row : document["rows"]) table.rows.push_back(detail_cells(row));
    return table;
}

Table adaptor_table(const Json& document) {
    require_comparison(document);
    Table table{{"scene", "rays", "path", "question", "direct Mrays/s", "adaptor Mrays/s",
                 "adaptor / direct", "95 % interval"},
                {}};
    for (const Json& row : at(document, {"embree_adaptor"})) {
        table.rows.push_back({row["scene"], row["kind"], row["path"], row["question"],
                              number_cell(number(at(row, {"direct_mrays_per_second"})), 3),
                              number_cell(number(at(row, {"adaptor_mrays_per_second"})), 3),
                              number_cell(number(at(row, {"adaptor_to_direct", "median"})), 3),
                              interval_cell(row, "adaptor_to_direct")});
    }
    return table;
}

std::string notes(const Json& document) {
    require_comparison(document);
    std::string text;
    bool sampled = false;
    std::map<std::string, std::string> refusals;
    for (const Json& row : document["rows"]) {
        const std::string name = row["name"];
        sampled = sampled || row.value("sampled", false);
        if (at(row, {"error"}).is_string())
            text += "error: " + name + ": " + row["error"].get<std::string>() + "\n";
        const std::string refused =
            row["scene"].get<std::string>() + ", " + row["structure"].get<std::string>();
        if (at(row, {"refusal"}).is_string()) refusals[refused] = row["refusal"];
    }
    for (const auto& [name, reason] : refusals) text += "n/a: " + name + ": " + reason + "\n";
    if (sampled) text += std::string(sampled_mark) + " measured on a sample of the rays\n";
    return text + adaptor_note(document) + control_note(document);
}

}  // namespace rayshoot
