#include "bench/textbook/textbook.h"

#include "bench/output/whole_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace rayshoot::textbook {
namespace {

using Json = nlohmann::ordered_json;

std::string names_of_figures() {
    std::string names;
    for (const Figure& figure : figures())
        names += (names.empty() ? "" : ", ") + std::string(figure.name);
    return names;
}

std::string or_nothing_said(const std::string& published) {
    return published.empty() ? "-" : published;
}

std::string image_line(const std::string& file, const std::string& caption) {
    return "![" + caption + "](" + file + ")\n\n*" + caption + "*\n\n";
}

std::string section(const FinishedFigure& finished) {
    const Sheet& sheet = finished.sheet;
    std::string text = "## " + std::string(finished.figure.name) + "\n\n" +
                       std::string(finished.figure.shows) + ".\n\n";
    for (const Picture& picture : sheet.pictures())
        text += image_line(picture.name + ".png", picture.caption);
    for (const Chart& chart : sheet.charts())
        text += image_line(chart.name + ".svg", chart.caption) + "[numbers](" + chart.name +
                ".csv)\n\n";
    for (const CaptionedTable& table : sheet.tables())
        text += table.caption + "\n\n" + to_markdown(table.table) + "\n";
    Table checks{{"check", "published", "ours", "verdict"}, {}};
    for (const Check& check : sheet.checks()) {
        checks.rows.push_back({check.claim, or_nothing_said(check.published), check.ours,
                               std::string(name_of(check.verdict))});
    }
    return text + to_markdown(checks) + "\n";
}

Json charts_json(std::span<const FinishedFigure> finished) {
    Json charts = Json::array();
    for (const FinishedFigure& one : finished) {
        for (const Chart& chart : one.sheet.charts()) {
            charts.push_back({{"name", chart.name}, {"x", chart.x}, {"y", chart.y}});
        }
    }
    return {{"schema", 1}, {"charts", charts}};
}

}  // namespace

std::vector<Figure> chosen_figures(std::span<const std::string> names) {
    if (names.empty()) return {figures().begin(), figures().end()};
    std::vector<Figure> chosen;
    for (const std::string& name : names) {
        const auto found = std::ranges::find(figures(), name, &Figure::name);
        if (found == figures().end())
            throw std::invalid_argument("no figure \"" + name + "\"; there are " +
                                        names_of_figures());
        chosen.push_back(*found);
    }
    return chosen;
}

std::vector<FinishedFigure> make_figures(const Studio& studio, std::span<const Figure> chosen,
                                         const std::filesystem::path& folder,
                                         const FigureProgress& progress) {
    std::vector<FinishedFigure> finished;
    for (const Figure& figure : chosen) {
        progress(std::string(figure.name));
        finished.push_back({figure, Sheet(folder)});
        figure.make(studio, finished.back().sheet);
    }
    return finished;
}

bool all_hold(std::span<const FinishedFigure> figures) {
    return std::ranges::all_of(figures, [](const auto& one) { return one.sheet.holds(); });
}

Table check_table(std::span<const FinishedFigure> figures) {
    Table table{{"figure", "check", "published", "ours", "verdict"}, {}};
    for (const FinishedFigure& one : figures) {
        for (const Check& check : one.sheet.checks()) {
            table.rows.push_back({std::string(one.figure.name), check.claim,
                                  or_nothing_said(check.published), check.ours,
                                  std::string(name_of(check.verdict))});
        }
    }
    return table;
}

Json to_json(std::span<const FinishedFigure> figures) {
    Json result = Json::array();
    for (const FinishedFigure& one : figures) {
        Json checks = Json::array(), pictures = Json::array(), charts = Json::array();
        for (const Check& check : one.sheet.checks()) {
            checks.push_back(
                {{"claim", check.claim},
                 {"published", check.published.empty() ? Json(nullptr) : Json(check.published)},
                 {"ours", check.ours},
                 {"verdict", name_of(check.verdict)}});
        }
        for (const Picture& picture : one.sheet.pictures()) pictures.push_back(picture.name);
        for (const Chart& chart : one.sheet.charts()) charts.push_back(chart.name);
        result.push_back({{"figure", one.figure.name},
                          {"pictures", pictures},
                          {"charts", charts},
                          {"checks", checks}});
    }
    return result;
}

void write_page(std::span<const FinishedFigure> figures, const std::filesystem::path& folder) {
    std::string page =
        "# Figures and tables of the textbook\n\nMade by `rayshoot textbook`; the curves drawn by "
        "`bench/textbook/curves.py`. A dash: the book gives no number, and the claim is checked "
        "against a derivation of its own.\n\n";
    for (const FinishedFigure& one : figures) page += section(one);
    write_whole_file(folder / "README.md", page);
    write_whole_file(folder / "charts.json", charts_json(figures).dump(2) + "\n");
}

}  // namespace rayshoot::textbook
