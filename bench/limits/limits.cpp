#include "bench/limits/limits.h"

#include "bench/comparison/document.h"
#include "bench/output/machine.h"
#include "bench/output/or_null.h"

#include <algorithm>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

Way measured_way(const Catalogue& catalogue, const std::string& name, const std::string& spec,
                 const CalibrationSettings& settings) {
    Way way{name, spec, {}, calibrate(catalogue, spec, settings)};
    way.costs = fit_costs(way.samples);
    return way;
}

ComparisonPlan with_ways(const LimitsPlan& plan) {
    ComparisonPlan all = plan.comparison;
    for (const std::string& way : {plan.in_flight, plan.alone}) {
        std::erase(all.structures, way);
        all.structures.insert(all.structures.begin(), way);
    }
    return all;
}

Json machine_json(const MachineLimits& machine) {
    Json latency = Json::array(), throughput = Json::array();
    for (const Latency& row : machine.latency) {
        latency.push_back({{"bytes", row.bytes},
                           {"ns_on_4_kib_pages", or_null(row.small_pages)},
                           {"ns_on_2_mib_pages", or_null(row.large_pages)}});
    }
    for (const Throughput& row : machine.throughput) {
        throughput.push_back({{"threads", row.threads},
                              {"bytes", machine.throughput_bytes},
                              {"mlines_per_second_on_4_kib_pages", or_null(row.small_pages)},
                              {"mlines_per_second_on_2_mib_pages", or_null(row.large_pages)}});
    }
    return {{"cycles_per_ns", or_null(machine.cycles_per_ns)},
            {"latency", latency},
            {"throughput", throughput}};
}

Json way_json(const Way& way, std::optional<double> cycles_per_ns) {
    const auto cycles = [&](double ns) {
        return cycles_per_ns ? Json(*cycles_per_ns * ns) : Json(nullptr);
    };
    Json samples = Json::array();
    for (const CostSample& sample : way.samples) {
        samples.push_back({{"steps", sample.steps},
                           {"leaves", sample.leaves},
                           {"ns", sample.ns},
                           {"predicted_ns", way.costs.ns(sample.steps, sample.leaves)}});
    }
    return {{"way", way.name},
            {"structure", way.spec},
            {"ns_per_ray", way.costs.per_ray},
            {"ns_per_step", way.costs.per_step},
            {"ns_per_leaf", way.costs.per_leaf},
            {"cycles_per_ray", cycles(way.costs.per_ray)},
            {"cycles_per_step", cycles(way.costs.per_step)},
            {"cycles_per_leaf", cycles(way.costs.per_leaf)},
            {"residual", way.costs.residual},
            {"samples", samples}};
}

double per_ray(const Row& row, Event event) {
    return static_cast<double>(row.counts->total[event]) / static_cast<double>(row.counts->rays);
}

/// Mrays/s, by way, of the work that the way `alone` counted on this scene and kind of rays.
Json bounds_json(const Row& alone, const Limits& limits) {
    Json result{{"scene", alone.name.scene},
                {"kind", alone.name.kind},
                {"threads", alone.threads},
                {"steps_per_ray", per_ray(alone, Event::step)},
                {"leaves_per_ray", per_ray(alone, Event::cell)},
                {"object_tests_per_ray", per_ray(alone, Event::object_test)},
                {"tree_bytes", or_null(alone.footprint.bytes)},
                {"latency_ns", nullptr},
                {"mrays_per_second", Json::object()}};
    if (const auto bytes = alone.footprint.bytes)
        result["latency_ns"] = or_null(limits.machine.latency_at(*bytes));
    for (const Way& way : limits.ways) {
        const double ns = way.costs.ns(per_ray(alone, Event::step), per_ray(alone, Event::cell));
        result["mrays_per_second"][way.name] = ns > 0 ? Json(1e3 * alone.threads / ns) : Json();
    }
    return result;
}

/// What a structure reached, and its share of each bound.
Json share_json(const Row& row, const Json& bounds) {
    Json result{{"name", to_string(row.name)},
                {"scene", row.name.scene},
                {"kind", row.name.kind},
                {"structure", row.name.spec},
                {"mrays_per_second", to_json(row.mrays_per_second)},
                {"share", Json::object()},
                {"error", row.error.empty() ? Json(nullptr) : Json(row.error)}};
    for (const auto& [way, bound] : bounds["mrays_per_second"].items()) {
        const bool known = row.mrays_per_second && bound.is_number();
        result["share"][way] =
            known ? Json(row.mrays_per_second->median / bound.get<double>()) : Json(nullptr);
    }
    return result;
}

/// The first structure of every stream is the way alone.
bool starts_a_stream(const std::vector<Row>& rows, std::size_t i) {
    return i == 0 || rows[i].name.scene != rows[i - 1].name.scene ||
           rows[i].name.kind != rows[i - 1].name.kind;
}

void add_bounds_and_shares(const Limits& limits, Json& document) {
    Json bounds = Json::array(), shares = Json::array();
    const std::vector<Row>& rows = limits.comparison.rows;
    bool known = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (starts_a_stream(rows, i)) {
            known = rows[i].counts && rows[i].counts->available && rows[i].counts->rays > 0;
            if (known) bounds.push_back(bounds_json(rows[i], limits));
        }
        if (known) shares.push_back(share_json(rows[i], bounds.back()));
    }
    document["bounds"] = std::move(bounds);
    document["shares"] = std::move(shares);
}

}  // namespace

Limits measure_limits(const Catalogue& catalogue, const LimitsPlan& plan) {
    const ComparisonPlan all = with_ways(plan);
    require_valid(catalogue, all);
    Limits limits;
    limits.ways = {measured_way(catalogue, "alone", plan.alone, plan.calibration),
                   measured_way(catalogue, "in flight", plan.in_flight, plan.calibration)};
    limits.machine = measure_machine(plan.largest);
    limits.comparison = compare(catalogue, all);
    return limits;
}

Json to_document(const LimitsPlan& plan, const Limits& limits) {
    Json document = to_document(with_ways(plan), limits.comparison);
    document["document"] = "limits";
    document["machine"] = machine_json(limits.machine);
    document["costs"] = Json::array();
    for (const Way& way : limits.ways)
        document["costs"].push_back(way_json(way, limits.machine.cycles_per_ns));
    add_bounds_and_shares(limits, document);
    return document;
}

}  // namespace rayshoot
