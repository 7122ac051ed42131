#include "bench/programs/checked_case.h"
#include "bench/programs/program.h"
#include "bench/timing/build_meter.h"

#include <benchmark/benchmark.h>

/// Rows build/<scene>/<structure>: building a structure over a scene that is in memory.
namespace rayshoot {
namespace {

void time_build(benchmark::State& state, const Catalogue& catalogue, const CheckedCase& checked,
                int threads) {
    if (!checked.error.empty()) {
        state.SkipWithError(checked.error.c_str());
        return;
    }
    const BuildInput input = build_input(*checked.scene, checked.format);
    std::optional<std::uint64_t> peak;
    bool first = true;  // measuring memory takes longer than a small build
    for (auto _ : state) {
        const MeasuredBuild made =
            (first ? measured_build : timed_build)(catalogue, checked.spec, input, threads);
        state.SetIterationTime(made.seconds);
        if (first) peak = made.peak_bytes;
        first = false;
    }
    state.counters["primitives"] = static_cast<double>(input.geometry.size());
    if (peak) state.counters["peak_bytes"] = static_cast<double>(*peak);
}

void register_cases(const Catalogue& catalogue, const ComparisonPlan& plan) {
    for (auto& checked : checked_cases(catalogue, plan, "build")) {
        benchmark::RegisterBenchmark(
            row_name("build", *checked).c_str(),
            [catalogue, checked, threads = plan.threads](benchmark::State& state) {
                time_build(state, catalogue, *checked, threads);
            })
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace
}  // namespace rayshoot

int main(int argc, char** argv) {
    return rayshoot::run_program("build", rayshoot::register_cases, argc, argv);
}
