#pragma once

#include "bench/comparison/compare.h"
#include "bench/limits/calibration.h"
#include "bench/limits/machine_limits.h"
#include "bench/output/table.h"

/// How fast a ray could be answered here, and how much of that is reached.
namespace rayshoot {

/// A way through the tree, what it costs where memory costs nothing, and what that rests on.
struct Way {
    std::string name;  ///< "alone", "in flight"
    std::string spec;
    CostModel costs;
    std::vector<CostSample> samples;
};

struct LimitsPlan {
    ComparisonPlan comparison;  ///< its structures: what is held against the bounds
    std::string alone = "bvh8:packets=off,flight=1";
    std::string in_flight = "bvh8:packets=off,flight=16";
    std::size_t largest = std::size_t{1} << 30;  ///< bytes of the largest working set
    CalibrationSettings calibration;
};

struct Limits {
    MachineLimits machine;
    std::vector<Way> ways;
    Comparison comparison;  ///< of the two ways and the structures asked for
};

/// Throws as compare and calibrate do.
Limits measure_limits(const Catalogue& catalogue, const LimitsPlan& plan);

/// Everything, with the bounds and shares that follow from it. A bound is threads over costs.ns of
/// the counts of the way `alone`; a share is a structure's rate over a bound.
nlohmann::ordered_json to_document(const LimitsPlan& plan, const Limits& limits);

/// The document's four tables: machine, costs, bounds and shares, with a heading each.
std::string limits_text(const nlohmann::ordered_json& document);

}  // namespace rayshoot
