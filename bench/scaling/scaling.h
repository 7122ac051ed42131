#pragma once

#include "bench/comparison/compare.h"
#include "bench/statistics/power_law.h"

/// How the costs of structures grow with the number of primitives.
namespace rayshoot {

/// Scenes of one sort and growing size: spd/tetra, spd/balls, soup.
inline constexpr std::array<std::string_view, 3> scene_families{"tetra", "balls", "soup"};
inline constexpr double least_primitives = 500;

/// The family's scenes of least_primitives to `most` primitives, in that order. Throws
/// std::invalid_argument, saying what is accepted, for an unknown family, and where fewer than two
/// scenes are left.
std::vector<std::string> scenes_of_family(std::string_view family, double most);

struct ScalingPlan {
    std::vector<std::string> families{scene_families.begin(), scene_families.end()};
    double most = 1.1e6;        ///< primitives
    ComparisonPlan comparison;  ///< its scenes are those of the families
};

/// Sets the scenes of the comparison. Throws as scenes_of_family does.
void choose_scenes(ScalingPlan& plan);

/// The comparison, and per family, structure and quantity the power of the number of primitives
/// that fits best (`exponents`). Quantities: build_seconds, bytes, and for each kind of rays
/// seconds, steps and object tests per ray. A quantity that is 0 or not measured somewhere has
/// none.
nlohmann::ordered_json to_document(const ScalingPlan& plan, const Comparison& comparison);

/// The document's two tables: the exponents, and what they were fitted to.
std::string scaling_text(const nlohmann::ordered_json& document);

}  // namespace rayshoot
