#pragma once

#include "bench/comparison/compare.h"
#include "bench/output/table.h"

#include <nlohmann/json.hpp>

/// A comparison as the JSON document that is kept, and the tables made of such documents.
namespace rayshoot {

inline constexpr int schema_version = 1;  // keys are only ever added

/// Everything that was measured, raw samples included.
nlohmann::ordered_json to_document(const ComparisonPlan& plan, const Comparison& comparison);

/// Rows: scene x structure. Columns: build time, bytes per primitive, means per ray over the kinds,
/// then Mrays/s per kind and its ratio to Embree. Throws std::invalid_argument for a JSON that is
/// no such document.
Table comparison_table(const nlohmann::ordered_json& document);

/// Every row in full: counts and rates with their intervals, one line per ray kind.
Table detail_table(const nlohmann::ordered_json& document);

/// What our interface costs Embree: its adaptor over direct calls, per path and question.
Table adaptor_table(const nlohmann::ordered_json& document);

/// What failed, what was refused and why, and what the marks in the tables mean.
std::string notes(const nlohmann::ordered_json& document);

/// Throws std::invalid_argument, naming what is missing, for a JSON that is no comparison.
void require_comparison(const nlohmann::ordered_json& document);

}  // namespace rayshoot
