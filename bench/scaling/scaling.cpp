#include "bench/scaling/scaling.h"

#include "bench/comparison/cells.h"
#include "bench/comparison/document.h"

#include <algorithm>
#include <cmath>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

struct Sized {
    std::string scene;
    double primitives;
};

/// Every size there is from 10^3 to 10^6, or half that far apart.
std::vector<Sized> all_of(std::string_view family) {
    std::vector<Sized> scenes;
    if (family == "tetra") {
        for (int size = 5; size <= 10; ++size)
            scenes.push_back({"spd/tetra:size=" + std::to_string(size), std::pow(4, size)});
    } else if (family == "balls") {
        for (int size = 3; size <= 6; ++size)
            scenes.push_back(
                {"spd/balls:size=" + std::to_string(size), (std::pow(9, size + 1) - 1) / 8 + 1});
    } else {
        for (const int count : {1000, 3000, 10000, 30000, 100000, 300000, 1000000})
            scenes.push_back({"soup:count=" + std::to_string(count), double(count)});
    }
    return scenes;
}

/// What is fitted, and where a row has it.
struct Quantity {
    std::string name;
    std::vector<const char*> path;
    bool per_kind = true;  ///< else the same in the rows of all kinds
};
const std::vector<Quantity>& quantities() {
    static const std::vector<Quantity> all{{"build_seconds", {"build_seconds"}, false},
                                           {"bytes", {"bytes"}, false},
                                           {"seconds_per_ray", {"mrays_per_second", "median"}},
                                           {"steps_per_ray", {"per_ray", "steps"}},
                                           {"object_tests_per_ray", {"per_ray", "object_tests"}}};
    return all;
}

std::optional<double> value_of(const Json& row, const Quantity& quantity) {
    Json value = row;
    for (const char* key : quantity.path) value = at(value, {key});
    const std::optional<double> found = number(value);
    if (!found || !(*found > 0)) return std::nullopt;
    return quantity.name == "seconds_per_ray" ? 1e-6 / *found : *found;
}

/// Rows of one structure and kind, on the scenes of one family.
std::vector<const Json*> rows_of(const Json& rows, const std::vector<std::string>& scenes,
                                 const Json& structure, const Json& kind) {
    std::vector<const Json*> chosen;
    for (const Json& row : rows)
        if (std::ranges::count(scenes, row["scene"].get<std::string>()) > 0 &&
            row["structure"] == structure && row["kind"] == kind)
            chosen.push_back(&row);
    return chosen;
}

Json exponent_of(const std::vector<const Json*>& rows, const Quantity& quantity) {
    std::vector<double> sizes, values;
    for (const Json* row : rows)
        if (const auto value = value_of(*row, quantity)) {
            sizes.push_back((*row)["primitives"]);
            values.push_back(*value);
        }
    if (values.size() < rows.size() || values.size() < 2)
        return {{"exponent", nullptr}, {"standard_error", nullptr}, {"factor", nullptr}};
    const PowerLaw law = fit_power_law(sizes, values);
    return {{"exponent", law.exponent},
            {"standard_error", values.size() > 2 ? Json(law.standard_error) : Json(nullptr)},
            {"factor", law.factor}};
}

/// Each once, in order of first mention.
std::vector<Json> distinct(const Json& rows, const char* key) {
    std::vector<Json> values;
    for (const Json& row : rows)
        if (std::ranges::count(values, row[key]) == 0) values.push_back(row[key]);
    return values;
}

Json exponents(const ScalingPlan& plan, const Json& rows) {
    Json found = Json::array();
    for (const std::string& family : plan.families)
        for (const Json& structure : distinct(rows, "structure"))
            for (const Quantity& quantity : quantities())
                for (const Json& kind : distinct(rows, "kind")) {
                    const auto scenes = scenes_of_family(family, plan.most);
                    Json entry = {{"family", family},
                                  {"structure", structure},
                                  {"quantity", quantity.name},
                                  {"kind", quantity.per_kind ? kind : Json(nullptr)}};
                    entry.update(exponent_of(rows_of(rows, scenes, structure, kind), quantity));
                    found.push_back(std::move(entry));
                    if (!quantity.per_kind) break;
                }
    return found;
}

std::string text_of(const Json& value) { return value.is_null() ? "" : value.get<std::string>(); }

}  // namespace

std::vector<std::string> scenes_of_family(std::string_view family, double most) {
    if (std::ranges::count(scene_families, family) == 0) {
        std::string known;
        for (const std::string_view name : scene_families)
            known += (known.empty() ? "" : ", ") + std::string(name);
        throw std::invalid_argument("no scenes of growing size are called '" + std::string(family) +
                                    "'; there are " + known);
    }
    std::vector<std::string> scenes;
    for (const Sized& sized : all_of(family))
        if (sized.primitives >= least_primitives && sized.primitives <= most)
            scenes.push_back(sized.scene);
    if (scenes.size() < 2)
        throw std::invalid_argument("growth shows in two scenes at least: " + std::string(family) +
                                    " has them up to 10000 primitives and more");
    return scenes;
}

void choose_scenes(ScalingPlan& plan) {
    plan.comparison.scenes.clear();
    for (const std::string& family : plan.families)
        for (const std::string& scene : scenes_of_family(family, plan.most))
            plan.comparison.scenes.push_back(scene);
}

Json to_document(const ScalingPlan& plan, const Comparison& comparison) {
    Json document = to_document(plan.comparison, comparison);
    document["document"] = "scaling";
    document["families"] = plan.families;
    document["exponents"] = exponents(plan, document["rows"]);
    return document;
}

std::string scaling_text(const Json& document) {
    Table growth{{"scenes", "structure", "quantity", "rays", "exponent", "standard error"}, {}};
    for (const Json& entry : document["exponents"])
        growth.rows.push_back({entry["family"], entry["structure"], entry["quantity"],
                               text_of(entry["kind"]), number_cell(number(entry["exponent"]), 3),
                               number_cell(number(entry["standard_error"]), 2)});
    Table measured{{"scene", "primitives", "structure", "rays"}, {}};
    for (const Quantity& quantity : quantities()) measured.headings.push_back(quantity.name);
    for (const Json& row : document["rows"]) {
        std::vector<std::string> cells{row["scene"], row["primitives"].dump(), row["structure"],
                                       row["kind"]};
        for (const Quantity& quantity : quantities())
            cells.push_back(number_cell(value_of(row, quantity), 4));
        measured.rows.push_back(std::move(cells));
    }
    return "Growth with the number of primitives: the power that fits best\n" + to_text(growth) +
           "\nMeasured\n" + to_text(measured) + notes(document);
}

}  // namespace rayshoot
