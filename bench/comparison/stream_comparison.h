#pragma once

#include "bench/comparison/compare.h"
#include "bench/comparison/contestant.h"

namespace rayshoot {

struct StreamResult {
    StreamSummary summary;
    std::vector<Row> rows;
    std::vector<double> control_samples;
};

/// Every candidate on one stream: judged, counted, then timed in interleaved blocks.
StreamResult compare_stream(const StreamContext& context, const std::vector<Candidate>& candidates,
                            ControlKernel& control, Progress& progress);

}  // namespace rayshoot
