#pragma once

#include "bench/comparison/candidate.h"
#include "bench/comparison/row.h"
#include "bench/output/progress.h"
#include "bench/timing/control.h"
#include "data/scene.h"

#include <nlohmann/json.hpp>

/// Runs a plan: gate, count, then time in blocks of every structure once.
namespace rayshoot {

struct StreamSummary {
    std::string scene, kind, digest;  ///< of the reference's answers
    std::size_t rays = 0, hits = 0, oracle_rays = 0;
    std::vector<double> control_samples;  ///< as below, of this stream's blocks
};

struct SceneSummary {
    std::string name, digest;
    std::uint64_t primitives = 0;
};

struct Comparison {
    std::vector<SceneSummary> scenes;
    std::vector<StreamSummary> streams;
    std::vector<Row> rows;
    nlohmann::ordered_json adaptor = nlohmann::ordered_json::array();  ///< see adaptor_cost.h
    std::vector<double> control_samples;  ///< seconds of the control kernel: medians of blocks

    /// A row of it is an error: a wrong answer, or a build that failed.
    bool failed() const;
};

/// Throws std::invalid_argument or runtime_error for input that cannot be used; a structure that
/// fails is an error row instead.
Comparison compare(const Catalogue& catalogue, const ComparisonPlan& plan);

}  // namespace rayshoot
