#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace rayshoot {

/// What was not measured is null, never 0.
template <class Value>
nlohmann::ordered_json or_null(const std::optional<Value>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace rayshoot
