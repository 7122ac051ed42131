#include "bench/comparison/document.h"

#include "bench/comparison/summary.h"
#include "bench/output/machine.h"
#include "bench/output/or_null.h"
#include "bench/timing/steadiness.h"

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

Json settings(const ComparisonPlan& plan) {
    return {{"width", plan.format.width},
            {"height", plan.format.height},
            {"spp", plan.format.spp},
            {"threads", plan.threads},
            {"repetitions", plan.repetitions},
            {"builds", plan.builds},
            {"batch", plan.batch},
            {"seed", plan.seed},
            {"confidence", default_confidence},
            {"protocol", plan.protocol.empty() ? Json(nullptr) : Json(plan.protocol)}};
}

Json noise(const std::vector<double>& samples) {
    if (samples.empty()) return {{"median_seconds", nullptr}, {"relative_spread", nullptr}};
    return {{"median_seconds", median(samples)}, {"relative_spread", relative_spread(samples)}};
}

/// How still the machine held over the whole run, and whether that makes it void.
Json control(const std::vector<double>& samples, double void_above) {
    const Steadiness steady = steadiness(samples, void_above);
    return {{"blocks", samples.size()},
            {"block_seconds", samples},
            {"median_seconds", samples.empty() ? Json(nullptr) : Json(median(samples))},
            {"moved", or_null(steady.moved)},
            {"void_above", void_above},
            {"void", or_null(steady.is_void())}};
}

}  // namespace

Json to_document(const ComparisonPlan& plan, const Comparison& comparison) {
    Json document;
    document["schema"] = schema_version;
    document["document"] = "bench";
    document["provenance"] = provenance();
    document["settings"] = settings(plan);
    document["machine_noise"] = noise(comparison.control_samples);
    document["control"] = control(comparison.control_samples, plan.void_above);
    document["scenes"] = Json::array();
    for (const SceneSummary& scene : comparison.scenes) {
        document["scenes"].push_back(
            {{"name", scene.name}, {"digest", scene.digest}, {"primitives", scene.primitives}});
    }
    document["streams"] = Json::array();
    for (const StreamSummary& stream : comparison.streams) {
        const auto moved = steadiness(stream.control_samples, plan.void_above).moved;
        document["streams"].push_back({{"scene", stream.scene},
                                       {"kind", stream.kind},
                                       {"rays", stream.rays},
                                       {"hits", stream.hits},
                                       {"oracle_rays", stream.oracle_rays},
                                       {"digest", stream.digest},
                                       {"control_moved", or_null(moved)}});
    }
    document["rows"] = Json::array();
    for (const Row& row : comparison.rows) document["rows"].push_back(to_json(row));
    document["embree_adaptor"] = comparison.adaptor;
    document["over_best_embree"] = summarise(document);
    return document;
}

}  // namespace rayshoot
