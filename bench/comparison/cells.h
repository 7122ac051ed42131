#pragma once

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <string>

/// Cells of tables, from values of a document that may be null or not be there.
namespace rayshoot {

/// value[first][second]..., null where one is not there.
nlohmann::ordered_json at(const nlohmann::ordered_json& value,
                          std::initializer_list<const char*> path);

std::optional<double> number(const nlohmann::ordered_json& value);

/// "low to high" of the estimate row[what], or n/a.
std::string interval_cell(const nlohmann::ordered_json& row, const char* what);

}  // namespace rayshoot
