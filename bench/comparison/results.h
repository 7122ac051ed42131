#pragma once

#include "bench/comparison/document.h"

#include <filesystem>

/// A folder of results: raw JSON, and tables that are generated from it and never typed.
namespace rayshoot {

/// Throws std::invalid_argument for what is no folder that can be written to.
void require_results_root(const std::filesystem::path& root);

/// Creates <root>/<date>-<processor> with raw.json and the tables; returns its path.
std::string write_results(const std::filesystem::path& root,
                          const nlohmann::ordered_json& document);

/// comparison.md, comparison.csv, rows.csv and README.md into `folder`.
void write_tables(const std::filesystem::path& folder, const nlohmann::ordered_json& document);

}  // namespace rayshoot
