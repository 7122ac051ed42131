#pragma once

#include "bench/output/table.h"

#include <nlohmann/json.hpp>

/// A whole comparison in a few numbers: every structure over Embree's best path.
namespace rayshoot {

/// {"means": [{"structure", "kind", "scenes", "ratio": {"median", "low", "high"}}],
///  "below_one": [row name, ...]}. A ratio is the geometric mean, over the scenes that the row was
/// timed on, of the median over blocks; its interval is bootstrap_geometric_mean's. below_one:
/// rows, of others than Embree, whose interval of ratio_to_best_embree ends below 1. Both are empty
/// where no Embree ran; rows on kept sessions are left out.
nlohmann::ordered_json summarise(const nlohmann::ordered_json& document);

/// The means, a line per structure and ray kind.
Table summary_table(const nlohmann::ordered_json& document);

/// The rows below one, one a line, with their intervals; "" where no Embree ran.
std::string below_embree_text(const nlohmann::ordered_json& document);

}  // namespace rayshoot
