#include "bench/programs/row_reporter.h"

#include "bench/output/machine.h"
#include "bench/output/table.h"
#include "bench/statistics/estimate.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <ostream>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const Estimate& estimate) {
    return {{"median", estimate.median}, {"low", estimate.low}, {"high", estimate.high}};
}

Json or_null(const std::optional<Estimate>& estimate) {
    return estimate ? to_json(*estimate) : Json(nullptr);
}

/// Millions per second; nothing of nothing.
std::optional<Estimate> rate(const std::vector<double>& seconds, double things) {
    if (things <= 0) return std::nullopt;
    std::vector<double> rates;
    for (const double value : seconds) rates.push_back(1e-6 * things / value);
    return bootstrap_median(rates);
}

std::string cell(const std::optional<Estimate>& estimate) {
    return number_cell(estimate ? std::optional(estimate->median) : std::nullopt);
}

/// Megabytes of 10^6.
std::string megabytes(const std::vector<double>& bytes) {
    return number_cell(bytes.empty() ? std::nullopt : std::optional(1e-6 * median(bytes)), 3);
}

double counter(const benchmark::BenchmarkReporter::Run& run, const char* name) {
    const auto found = run.counters.find(name);
    return found == run.counters.end() ? 0 : found->second.value;
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
        row.rays = counter(run, "rays");
        row.primitives = counter(run, "primitives");
        if (const double peak = counter(run, "peak_bytes"); peak > 0) row.peaks.push_back(peak);
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
    const bool builds =
        std::ranges::any_of(rows_, [](const auto& named) { return named.second.primitives > 0; });
    Table table{{"row", "ms", "95 % interval"}, {}};
    if (builds) table.headings.insert(table.headings.end(), {"Mprimitives/s", "peak MB"});
    else table.headings.push_back("Mrays/s");
    for (const std::string& name : order_) {
        const Samples& row = rows_[name];
        const Estimate time = bootstrap_median(row.seconds);
        std::vector<std::string> cells{
            name, number_cell(1e3 * time.median),
            number_cell(1e3 * time.low) + " to " + number_cell(1e3 * time.high)};
        cells.push_back(cell(rate(row.seconds, builds ? row.primitives : row.rays)));
        if (builds) cells.push_back(megabytes(row.peaks));
        table.rows.push_back(std::move(cells));
    }
    GetOutputStream() << to_text(table);
}

void RowReporter::write_json() {
    Json document{{"schema", 1}, {"provenance", provenance()}, {"rows", Json::array()}};
    for (const std::string& name : order_) {
        const Samples& row = rows_[name];
        const auto rays = rate(row.seconds, row.rays);
        const auto built = rate(row.seconds, row.primitives);
        document["rows"].push_back(
            {{"name", name},
             {"seconds", to_json(bootstrap_median(row.seconds))},
             {"seconds_samples", row.seconds},
             {"mrays_per_second", or_null(rays)},
             {"build_mprimitives_per_second", or_null(built)},
             {"build_peak_bytes", row.peaks.empty() ? Json(nullptr) : Json(median(row.peaks))}});
    }
    GetOutputStream() << document.dump(2) << '\n';
}

}  // namespace rayshoot
