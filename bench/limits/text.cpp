#include "bench/comparison/cells.h"
#include "bench/comparison/document.h"
#include "bench/limits/limits.h"

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

std::string cell(const Json& value, int digits = 3) { return number_cell(number(value), digits); }

std::string percent(const Json& share) {
    const auto value = number(share);
    return number_cell(value ? std::optional(100 * *value) : std::nullopt, 3);
}

/// Of the powers of two that are measured: "16 KiB", "1 GiB".
std::string size_cell(std::size_t bytes) {
    constexpr std::array units{" B", " KiB", " MiB", " GiB"};
    std::size_t unit = 0;
    for (; unit + 1 < units.size() && bytes >= 1024; ++unit) bytes /= 1024;
    return std::to_string(bytes) + units[unit];
}

Table latency_table(const Json& machine) {
    Table table{{"working set", "ns, 4 KiB pages", "ns, 2 MiB pages"}, {}};
    for (const Json& row : machine["latency"]) {
        table.rows.push_back({size_cell(row["bytes"]), cell(row["ns_on_4_kib_pages"]),
                              cell(row["ns_on_2_mib_pages"])});
    }
    return table;
}

Table throughput_table(const Json& machine) {
    Table table{{"threads", "working set", "M lines/s, 4 KiB pages", "M lines/s, 2 MiB pages"}, {}};
    for (const Json& row : machine["throughput"]) {
        table.rows.push_back({row["threads"].dump(), size_cell(row["bytes"]),
                              cell(row["mlines_per_second_on_4_kib_pages"]),
                              cell(row["mlines_per_second_on_2_mib_pages"])});
    }
    return table;
}

Table cost_table(const Json& document) {
    Table table{{"way", "structure", "ns/ray", "ns/step", "ns/leaf", "cycles/ray", "cycles/step",
                 "cycles/leaf", "residual %", "samples"},
                {}};
    for (const Json& way : document["costs"]) {
        table.rows.push_back({way["way"], way["structure"], cell(way["ns_per_ray"]),
                              cell(way["ns_per_step"]), cell(way["ns_per_leaf"]),
                              cell(way["cycles_per_ray"]), cell(way["cycles_per_step"]),
                              cell(way["cycles_per_leaf"]), percent(way["residual"]),
                              std::to_string(way["samples"].size())});
    }
    return table;
}

Table bound_table(const Json& document) {
    Table table{{"scene", "rays", "steps/ray", "leaves/ray", "object tests/ray", "tree bytes",
                 "latency ns"},
                {}};
    for (const Json& way : document["costs"])
        table.headings.push_back(way["way"].get<std::string>() + " Mrays/s");
    for (const Json& row : document["bounds"]) {
        std::vector<std::string> cells{row["scene"],
                                       row["kind"],
                                       cell(row["steps_per_ray"]),
                                       cell(row["leaves_per_ray"]),
                                       cell(row["object_tests_per_ray"]),
                                       cell(row["tree_bytes"]),
                                       cell(row["latency_ns"])};
        for (const auto& [way, bound] : row["mrays_per_second"].items())
            cells.push_back(cell(bound));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

Table share_table(const Json& document) {
    Table table{{"row", "Mrays/s", "95 % interval"}, {}};
    for (const Json& way : document["costs"])
        table.headings.push_back("% of " + way["way"].get<std::string>());
    for (const Json& row : document["shares"]) {
        std::vector<std::string> cells{row["name"], cell(at(row, {"mrays_per_second", "median"})),
                                       interval_cell(row, "mrays_per_second")};
        for (const auto& [way, share] : row["share"].items()) cells.push_back(percent(share));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

}  // namespace

std::string limits_text(const Json& document) {
    const Json& machine = document["machine"];
    return "Clock: " + cell(machine["cycles_per_ns"]) + " cycles per ns\n\nDependent loads\n" +
           to_text(latency_table(machine)) + "\nIndependent random cache lines\n" +
           to_text(throughput_table(machine)) +
           "\nCosts where the tree is in the first-level cache\n" + to_text(cost_table(document)) +
           "\nBounds: what the work counted costs at these prices\n" +
           to_text(bound_table(document)) +
           "\nReached; rays that go together share steps, so they may pass a bound\n" +
           to_text(share_table(document)) + notes(document);
}

}  // namespace rayshoot
