#pragma once

#include "bench/comparison/row_name.h"
#include "bench/gate/gate.h"
#include "bench/statistics/estimate.h"

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <vector>

/// One line of a comparison: a structure on a stream of a scene.
namespace rayshoot {

struct Row {
    RowName name;
    Agreement agreement = Agreement::exact;
    std::uint64_t primitives = 0;
    int threads = 1;
    std::size_t batch = default_batch;
    std::size_t rays = 0;                    ///< of the stream
    std::size_t timed_rays = 0;              ///< fewer for a structure that is timed on a sample
    std::vector<double> build_samples;       ///< seconds
    std::vector<std::uint64_t> build_peaks;  ///< bytes; fewer than builds where not measurable
    Footprint footprint;
    std::optional<StreamCounts> counts;
    Verdict verdict;
    std::vector<double> samples;  ///< seconds a pass, one per block
    std::optional<Estimate> mrays_per_second;
    std::optional<Estimate> ratio_to_embree;       ///< to the first of Embree's rows
    std::optional<Estimate> ratio_to_best_embree;  ///< to the one with the highest median
    std::string best_embree;                       ///< its spec; empty: no Embree in the run
    std::string refusal;  ///< why the structure cannot take the scene; not an error
    std::string error;    ///< why there is no time: the gate's reason, or a failed build

    bool sampled() const { return timed_rays < rays; }
    /// Mrays/s of each block.
    std::vector<double> rates() const;
    /// Million primitives per second of the builds; nothing when there was none, or of nothing.
    std::optional<Estimate> build_rate() const;
    /// The median of build_peaks, bytes.
    std::optional<double> build_peak() const;
};

/// The keys that the project's README documents, and more.
nlohmann::ordered_json to_json(const Row& row);

nlohmann::ordered_json to_json(const std::optional<Estimate>& estimate);
nlohmann::ordered_json to_json(const Footprint& footprint);
/// All twelve, by name; null where the structure cannot count.
nlohmann::ordered_json to_json(const Counters* counters);

}  // namespace rayshoot
