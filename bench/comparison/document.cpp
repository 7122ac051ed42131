#include "bench/comparison/document.h"

#include "bench/output/machine.h"

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

Json settings(const ComparisonPlan& plan) {
    return {
        {"width", plan.format.width}, {"height", plan.format.height},    {"spp", plan.format.spp},
        {"threads", plan.threads},    {"repetitions", plan.repetitions}, {"batch", plan.batch},
        {"seed", plan.seed},          {"confidence", default_confidence}};
}

Json noise(const std::vector<double>& samples) {
    if (samples.empty()) return {{"median_seconds", nullptr}, {"relative_spread", nullptr}};
    return {{"median_seconds", median(samples)}, {"relative_spread", relative_spread(samples)}};
}

}  // namespace

Json to_document(const ComparisonPlan& plan, const Comparison& comparison) {
    Json document;
    document["schema"] = schema_version;
    document["document"] = "bench";
    document["provenance"] = provenance();
    document["settings"] = settings(plan);
    document["machine_noise"] = noise(comparison.control_samples);
    document["scenes"] = Json::array();
    for (const SceneSummary& scene : comparison.scenes) {
        document["scenes"].push_back(
            {{"name", scene.name}, {"digest", scene.digest}, {"primitives", scene.primitives}});
    }
    document["streams"] = Json::array();
    for (const StreamSummary& stream : comparison.streams) {
        document["streams"].push_back({{"scene", stream.scene},
                                       {"kind", stream.kind},
                                       {"rays", stream.rays},
                                       {"hits", stream.hits},
                                       {"oracle_rays", stream.oracle_rays},
                                       {"digest", stream.digest}});
    }
    document["rows"] = Json::array();
    for (const Row& row : comparison.rows) document["rows"].push_back(to_json(row));
    document["embree_adaptor"] = comparison.adaptor;
    return document;
}

}  // namespace rayshoot
