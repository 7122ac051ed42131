#pragma once

#include "bench/textbook/figures.h"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>

/// The figures together: made, checked, and put on one page.
namespace rayshoot::textbook {

struct FinishedFigure {
    Figure figure;
    Sheet sheet;
};

/// By their names; all of them for none. Throws std::invalid_argument, listing what there is.
std::vector<Figure> chosen_figures(std::span<const std::string> names);

/// Called before each figure.
using FigureProgress = std::function<void(const std::string& name)>;

/// Makes the figures into `folder`, which exists.
std::vector<FinishedFigure> make_figures(const Studio& studio, std::span<const Figure> chosen,
                                         const std::filesystem::path& folder,
                                         const FigureProgress& progress);

bool all_hold(std::span<const FinishedFigure> figures);

/// Figure, check, published, ours, verdict: a line for each check.
Table check_table(std::span<const FinishedFigure> figures);
nlohmann::ordered_json to_json(std::span<const FinishedFigure> figures);

/// README.md, the page of all figures, and charts.json, what curves.py is to draw.
void write_page(std::span<const FinishedFigure> figures, const std::filesystem::path& folder);

}  // namespace rayshoot::textbook
