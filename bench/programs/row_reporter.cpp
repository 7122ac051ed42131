#include "bench/programs/row_reporter.h"

#include "bench/output/machine.h"
#include "bench/output/table.h"
#include "bench/statistics/estimate.h"

#include <nlohmann/json.hpp>

#include <ostream>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Estimate& estimate) {
    return {{"median", estimate.median}, {"low", estimate.low}, {"high", estimate.high}};
}

std::vector<double> rates(const std::vector<double>& seconds, double rays) {
    std::vector<double> result;
    for (const double value : seconds) result.push_back(1e-6 * rays / value);
    return result;
}

}  // namespace

void RowReporter::ReportRuns(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration) continue;  // aggregates are made here
        const std::string& name = run.run_name.function_name;
        if (run.error_occurred) {
            errors_[name] = run.error_message;
            continue;
        }
        if (!rows_.contains(name)) order_.push_back(name);
        Samples& row = rows_[name];
        row.seconds.push_back(run.real_accumulated_time / static_cast<double>(run.iterations));
        const auto rays = run.counters.find("rays");
        if (rays != run.counters.end()) row.rays = rays->second;
    }
}

void RowReporter::Finalize() {
    if (form_ == Form::text) write_text();
    else write_json();
    for (const auto& [name, message] : errors_) {
        GetErrorStream() << "error: " << name << ": " << message << '\n';
    }
    GetOutputStream().flush();
}

void RowReporter::write_text() {
    Table table{{"row", "ms", "95 % interval", "Mrays/s"}, {}};
    for (const std::string& name : order_) {
        const Samples& row = rows_[name];
        const Estimate time = bootstrap_median(row.seconds);
        const bool of_rays = row.rays > 0;
        table.rows.push_back(
            {name, number_cell(1e3 * time.median),
             number_cell(1e3 * time.low) + " to " + number_cell(1e3 * time.high),
             of_rays ? number_cell(median(rates(row.seconds, row.rays))) : not_measured});
    }
    GetOutputStream() << to_text(table);
}

void RowReporter::write_json() {
    Json document{{"schema", 1}, {"provenance", provenance()}, {"rows", Json::array()}};
    for (const std::string& name : order_) {
        const Samples& row = rows_[name];
        Json rate = nullptr;
        if (row.rays > 0) rate = to_json(bootstrap_median(rates(row.seconds, row.rays)));
        document["rows"].push_back({{"name", name},
                                    {"seconds", to_json(bootstrap_median(row.seconds))},
                                    {"seconds_samples", row.seconds},
                                    {"mrays_per_second", rate}});
    }
    GetOutputStream() << document.dump(2) << '\n';
}

}  // namespace rayshoot
