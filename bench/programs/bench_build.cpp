#include "bench/programs/checked_case.h"
#include "bench/programs/program.h"

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>

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
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    for (auto _ : state) {
        benchmark::DoNotOptimize(build(catalogue, checked.spec, input));
    }
}

void register_cases(const Catalogue& catalogue, const ComparisonPlan& plan) {
    for (auto& checked : checked_cases(catalogue, plan, "build")) {
        benchmark::RegisterBenchmark(
            row_name("build", *checked).c_str(),
            [catalogue, checked, threads = plan.threads](benchmark::State& state) {
                time_build(state, catalogue, *checked, threads);
            })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace
}  // namespace rayshoot

int main(int argc, char** argv) {
    return rayshoot::run_program("build", rayshoot::register_cases, argc, argv);
}
