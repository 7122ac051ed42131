#include "bench/limits/limits.h"

#include "bench/limits/probe_memory.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rayshoot {
namespace {

using Json = nlohmann::ordered_json;

std::vector<CostSample> priced(double per_ray, double per_step, double per_leaf) {
    std::vector<CostSample> samples{{1, 0, 0}, {2, 0.5, 0}, {4, 3, 0}, {7, 2, 0}, {11, 6, 0}};
    for (CostSample& sample : samples)
        sample.ns = per_ray + per_step * sample.steps + per_leaf * sample.leaves;
    return samples;
}

TEST(CostModel, finds_the_prices_that_made_the_samples) {
    const CostModel model = fit_costs(priced(5, 10, 20));
    EXPECT_NEAR(model.per_ray, 5, 1e-9);
    EXPECT_NEAR(model.per_step, 10, 1e-9);
    EXPECT_NEAR(model.per_leaf, 20, 1e-9);
    EXPECT_NEAR(model.residual, 0, 1e-12);
    EXPECT_NEAR(model.ns(3, 2), 75, 1e-9);
}

TEST(CostModel, has_no_negative_price) {
    const CostModel model = fit_costs(priced(-0.5, 10, 20));
    EXPECT_EQ(model.per_ray, 0);
    EXPECT_GT(model.per_step, 0);
    EXPECT_GT(model.per_leaf, 0);
    EXPECT_GT(model.residual, 0);
}

TEST(CostModel, residual_is_the_root_mean_square_of_relative_errors) {
    // The same work took 1 and 3: the best price for it under relative errors is 1.2.
    const std::vector<CostSample> samples{{1, 0, 1}, {1, 0, 3}, {1, 0, 1}, {1, 0, 3}};
    const CostModel model = fit_costs(samples);
    EXPECT_NEAR(model.ns(1, 0), 1.2, 1e-12);
    EXPECT_NEAR(model.residual, std::sqrt((0.04 + 0.36) / 2), 1e-12);
}

TEST(CostModel, of_too_few_samples_is_refused) {
    EXPECT_THROW(fit_costs(std::vector<CostSample>{{1, 1, 1}, {2, 1, 1}}), std::invalid_argument);
}

/// A row of 100 rays with 400 steps, 200 leaves and 300 tests, at `rate` Mrays/s.
Row row(const std::string& spec, double rate) {
    Row row;
    row.name = {"rays", "a/scene", spec, "camera"};
    row.threads = 2;
    row.rays = row.timed_rays = 100;
    row.footprint.bytes = 100000;
    row.counts.emplace();
    row.counts->available = true;
    row.counts->rays = 100;
    row.counts->total.totals[static_cast<std::size_t>(Event::step)] = 400;
    row.counts->total.totals[static_cast<std::size_t>(Event::cell)] = 200;
    row.counts->total.totals[static_cast<std::size_t>(Event::object_test)] = 300;
    row.mrays_per_second = Estimate{rate, rate, rate};
    return row;
}

Limits limits() {
    Limits limits;
    limits.machine.cycles_per_ns = 3;
    limits.machine.latency = {{16384, 1.0, 1.0}, {65536, 4.0, 3.0}, {262144, 9.0, std::nullopt}};
    limits.ways = {{"alone", "one", {10, 20, 55, 0}, {}}, {"in flight", "many", {0, 5, 15, 0}, {}}};
    limits.comparison.rows = {row("one", 5), row("many", 10), row("best", 20)};
    return limits;
}

TEST(Limits, bounds_are_threads_over_what_the_work_costs) {
    const Json document = to_document(LimitsPlan{}, limits());
    ASSERT_EQ(document["bounds"].size(), 1u);
    const Json& bound = document["bounds"][0];
    EXPECT_EQ(bound["steps_per_ray"], 4);
    EXPECT_EQ(bound["leaves_per_ray"], 2);
    EXPECT_EQ(bound["object_tests_per_ray"], 3);
    EXPECT_NEAR(bound["mrays_per_second"]["alone"], 2 * 1000.0 / (10 + 4 * 20 + 2 * 55), 1e-9);
    EXPECT_NEAR(bound["mrays_per_second"]["in flight"], 2 * 1000.0 / (4 * 5 + 2 * 15), 1e-9);
    EXPECT_NEAR(document["costs"][0]["cycles_per_step"], 60, 1e-9);
}

TEST(Limits, shares_are_rates_over_bounds) {
    const Json shares = to_document(LimitsPlan{}, limits())["shares"];
    ASSERT_EQ(shares.size(), 3u);
    EXPECT_NEAR(shares[0]["share"]["alone"], 0.5, 1e-9);
    EXPECT_NEAR(shares[2]["share"]["alone"], 2, 1e-9);
    EXPECT_NEAR(shares[2]["share"]["in flight"], 0.5, 1e-9);
}

TEST(Limits, latency_is_that_of_the_smallest_working_set_that_holds_the_tree) {
    const MachineLimits machine = limits().machine;
    EXPECT_EQ(machine.latency_at(1), 1.0);
    EXPECT_EQ(machine.latency_at(16385), 3.0);
    EXPECT_EQ(machine.latency_at(100000), 9.0);  // no large pages there
    EXPECT_FALSE(machine.latency_at(262145).has_value());
}

TEST(Limits, text_has_every_row_and_what_was_not_measured) {
    Limits partly = limits();
    partly.machine.cycles_per_ns.reset();
    partly.comparison.rows[2].mrays_per_second.reset();
    const std::string text = limits_text(to_document(LimitsPlan{}, partly));
    EXPECT_NE(text.find("rays/a/scene/best/camera"), std::string::npos);
    EXPECT_NE(text.find("256 KiB"), std::string::npos);
    EXPECT_NE(text.find("n/a"), std::string::npos);
}

TEST(MachineLimits, a_working_set_of_64_kib_is_measured_at_once) {
    const MachineLimits machine = measure_machine(std::size_t{1} << 16);
    ASSERT_EQ(machine.latency.size(), 2u);
    EXPECT_EQ(machine.latency[0].bytes, std::size_t{1} << 14);
    ASSERT_TRUE(machine.latency[0].small_pages.has_value());
    EXPECT_GT(*machine.latency[0].small_pages, 0.1);
    EXPECT_LT(*machine.latency[0].small_pages, 1000);
    ASSERT_EQ(machine.throughput.size(), 2u);
    EXPECT_GT(machine.throughput[0].small_pages.value_or(1), 0);
}

TEST(ProbeMemory, begins_at_a_large_page_and_is_as_large_as_asked) {
    for (const Pages pages : {Pages::small, Pages::large}) {
        const ProbeMemory memory(1000, pages);
        EXPECT_EQ(memory.lines().size(), 1000u);
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(memory.lines().data()) % (1u << 21), 0u);
    }
}

}  // namespace
}  // namespace rayshoot
