#include "bench/comparison/row.h"

#include "bench/output/or_null.h"

#include <nlohmann/json.hpp>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

/// Means over the rays that were counted.
Json means(const std::optional<StreamCounts>& counts) {
    if (!counts || !counts->available || counts->rays == 0) return nullptr;
    Json result = Json::object();
    for (const Event event :
         {Event::hit, Event::object_test, Event::object_hit, Event::bounding_volume_test,
          Event::step, Event::cell, Event::empty_cell, Event::mailbox_skip, Event::cache_hit,
          Event::candidate_set, Event::declined}) {
        result[std::string(event_names[static_cast<std::size_t>(event)])] =
            static_cast<double>(counts->total[event]) / static_cast<double>(counts->rays);
    }
    return result;
}

Json gate_to_json(const Row& row) {
    return {{"passed", row.verdict.passed},
            {"rays", row.verdict.compared},
            {"ambiguous", row.verdict.ambiguous},
            {"digest", text_or_null(row.verdict.digest)}};
}

}  // namespace

std::vector<double> Row::rates() const {
    std::vector<double> rates;
    for (const double seconds : samples) {
        rates.push_back(1e-6 * static_cast<double>(timed_rays) / seconds);
    }
    return rates;
}

std::optional<Estimate> Row::build_rate() const {
    if (build_samples.empty() || primitives == 0) return std::nullopt;
    std::vector<double> rates;
    for (const double seconds : build_samples) {
        rates.push_back(1e-6 * static_cast<double>(primitives) / seconds);
    }
    return bootstrap_median(rates);
}

std::optional<double> Row::build_peak() const {
    if (build_peaks.empty()) return std::nullopt;
    return median(std::vector<double>(build_peaks.begin(), build_peaks.end()));
}

Json to_json(const std::optional<Estimate>& estimate) {
    if (!estimate) return {{"median", nullptr}, {"low", nullptr}, {"high", nullptr}};
    return {{"median", estimate->median}, {"low", estimate->low}, {"high", estimate->high}};
}

Json to_json(const Footprint& footprint) {
    return {{"interior", or_null(footprint.interior)},
            {"leaves", or_null(footprint.leaves)},
            {"empty_leaves", or_null(footprint.empty_leaves)},
            {"references", or_null(footprint.references)},
            {"depth", or_null(footprint.depth)},
            {"bytes", or_null(footprint.bytes)},
            {"remark", footprint.remark}};
}

Json to_json(const Counters* counters) {
    Json result = Json::object();
    for (std::size_t i = 0; i < event_names.size(); ++i) {
        const std::string name(event_names[i]);
        if (counters) result[name] = counters->totals[i];
        else result[name] = nullptr;
    }
    return result;
}

Json to_json(const Row& row) {
    const bool built = !row.build_samples.empty();
    Json result;
    result["name"] = to_string(row.name);
    result["scene"] = row.name.scene;
    result["structure"] = row.name.spec;
    result["kind"] = row.name.kind;
    result["warm"] = row.name.family == "warm";
    result["agreement"] = row.agreement == Agreement::exact ? "exact" : "tolerance";
    result["threads"] = row.threads;
    result["batch"] = row.batch;
    result["primitives"] = row.primitives;
    result["rays"] = row.rays;
    result["timed_rays"] = row.timed_rays;
    result["sampled"] = row.sampled();
    result["build_seconds"] = built ? Json(median(row.build_samples)) : Json(nullptr);
    result["build_samples"] = row.build_samples;
    result["build_mprimitives_per_second"] = to_json(row.build_rate());
    result["build_peak_bytes"] = or_null(row.build_peak());
    result["build_peak_samples"] = row.build_peaks;
    result["bytes"] = or_null(row.footprint.bytes);
    result["footprint"] = to_json(row.footprint);
    result["per_ray"] = means(row.counts);
    result["gate"] = gate_to_json(row);
    result["seconds_samples"] = row.samples;
    result["mrays_per_second"] = to_json(row.mrays_per_second);
    result["ratio_to_embree"] = to_json(row.ratio_to_embree);
    result["ratio_to_best_embree"] = to_json(row.ratio_to_best_embree);
    result["best_embree"] = text_or_null(row.best_embree);
    result["refusal"] = text_or_null(row.refusal);
    result["error"] = text_or_null(row.error);
    return result;
}

}  // namespace rayshoot
