#pragma once

#include "bench/comparison/candidate.h"
#include "bench/comparison/row.h"
#include "bench/output/progress.h"

#include <list>
#include <memory>

namespace rayshoot {

struct StreamContext {
    const Catalogue& catalogue;
    const ComparisonPlan& plan;
    const BuildInput& input;
    const RayStream& stream;
};

/// A row with everything that timing it needs; without a tracer when it must not be timed.
struct Contestant {
    Row row;
    RayStream part;  ///< what it is timed on, when that is not the whole stream
    std::unique_ptr<StreamTracer> tracer;
};

/// Every row that the plan wants of this stream, each judged and counted.
/// A list, because a tracer refers to its contestant's part.
std::list<Contestant> contestants_of(const StreamContext& context,
                                     const std::vector<Candidate>& candidates, const Gate& gate,
                                     Progress& progress);

/// One pass: on fresh sessions or, in a warm row, on kept ones. Seconds.
double time_once(Contestant& contestant);

/// The gate as the plan sets it.
Gate make_gate(const StreamContext& context);

}  // namespace rayshoot
