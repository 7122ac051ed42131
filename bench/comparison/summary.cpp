#include "bench/comparison/summary.h"

#include "bench/comparison/cells.h"
#include "bench/comparison/row.h"

#include <algorithm>
#include <map>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

/// What a row's best Embree is found by: that one's own scene, kind and structure.
using Key = std::array<std::string, 3>;

Key key_of(const Json& row, const char* structure) {
    return {row["scene"], row["kind"], row[structure]};
}

bool counts(const Json& row) {
    return !row.value("warm", false) && at(row, {"best_embree"}).is_string();
}

std::map<Key, const Json*> embree_rows(const Json& document) {
    std::map<Key, const Json*> rows;
    for (const Json& row : document["rows"]) {
        if (counts(row) && is_embree(row["structure"].get<std::string>()))
            rows[key_of(row, "structure")] = &row;
    }
    return rows;
}

/// Block by block; a structure that was timed on a sample has fewer rays a pass.
std::vector<double> block_ratios(const Json& row, const Json& best) {
    const auto own = row["seconds_samples"].get<std::vector<double>>();
    const auto others = best["seconds_samples"].get<std::vector<double>>();
    const double rays = row["timed_rays"].get<double>() / best["timed_rays"].get<double>();
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(own.size(), others.size()); ++i)
        ratios.push_back(rays * others[i] / own[i]);
    return ratios;
}

/// All scenes of one structure and ray kind.
struct Line {
    std::string structure, kind;
    std::vector<std::vector<double>> ratios;  ///< by scene, of its blocks
};

Line& line_of(const Json& row, std::vector<Line>& lines) {
    const auto same = [&](const Line& line) {
        return row["structure"] == line.structure && row["kind"] == line.kind;
    };
    const auto found = std::ranges::find_if(lines, same);
    if (found != lines.end()) return *found;
    return lines.emplace_back(Line{row["structure"], row["kind"], {}});
}

std::vector<Line> lines_of(const Json& document) {
    const auto best = embree_rows(document);
    std::vector<Line> lines;
    for (const Json& row : document["rows"]) {
        if (!counts(row)) continue;
        const auto other = best.find(key_of(row, "best_embree"));
        if (other == best.end()) continue;
        std::vector<double> ratios = block_ratios(row, *other->second);
        if (!ratios.empty()) line_of(row, lines).ratios.push_back(std::move(ratios));
    }
    return lines;
}

bool is_below_one(const Json& row) {
    const auto high = number(at(row, {"ratio_to_best_embree", "high"}));
    return counts(row) && !is_embree(row["structure"].get<std::string>()) && high && *high < 1;
}

}  // namespace

Json summarise(const Json& document) {
    Json means = Json::array(), below = Json::array();
    for (const Line& line : lines_of(document)) {
        means.push_back({{"structure", line.structure},
                         {"kind", line.kind},
                         {"scenes", line.ratios.size()},
                         {"ratio", to_json(std::optional(bootstrap_geometric_mean(line.ratios)))}});
    }
    for (const Json& row : document["rows"]) {
        if (is_below_one(row)) below.push_back(row["name"]);
    }
    return {{"means", means}, {"below_one", below}};
}

Table summary_table(const Json& document) {
    Table table{{"structure", "rays", "scenes", "/ best Embree", "95 % interval"}, {}};
    const Json summary = summarise(document);
    for (const Json& line : summary["means"]) {
        table.rows.push_back({line["structure"], line["kind"], line["scenes"].dump(),
                              number_cell(number(line["ratio"]["median"]), 3),
                              interval_cell(line, "ratio")});
    }
    return table;
}

std::string below_embree_text(const Json& document) {
    if (lines_of(document).empty()) return "";
    std::string text;
    for (const Json& row : document["rows"]) {
        if (!is_below_one(row)) continue;
        text += row["name"].get<std::string>() + ": " + interval_cell(row, "ratio_to_best_embree") +
                " of " + row["best_embree"].get<std::string>() + "\n";
    }
    return text.empty() ? "no row is slower than Embree's best path beyond its interval\n"
                        : "rows slower than Embree's best path, beyond their intervals:\n" + text;
}

}  // namespace rayshoot
