#include "bench/comparison/cells.h"

#include "bench/output/table.h"

namespace rayshoot {

using Json = nlohmann::ordered_json;

Json at(const Json& value, std::initializer_list<const char*> path) {
    const Json* found = &value;
    for (const char* key : path) {
        if (!found->is_object() || !found->contains(key)) return nullptr;
        found = &(*found)[key];
    }
    return *found;
}

std::optional<double> number(const Json& value) {
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string interval_cell(const Json& row, const char* what) {
    const auto low = number(at(row, {what, "low"})), high = number(at(row, {what, "high"}));
    if (!low || !high) return not_measured;
    return number_cell(low, 3) + " to " + number_cell(high, 3);
}

}  // namespace rayshoot
