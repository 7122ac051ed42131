#include "bench/programs/checked_case.h"
#include "bench/programs/program.h"
#include "tracer/render.h"

#include <benchmark/benchmark.h>

/// Rows render/<scene>/<structure>: a whole image under the SPD rules.
namespace rayshoot {
namespace {

void time_render(benchmark::State& state, const CheckedCase& checked, int threads) {
    if (!checked.error.empty()) {
        state.SkipWithError(checked.error.c_str());
        return;
    }
    RenderSettings settings;
    settings.format = checked.format;
    settings.threads = threads;
    for (auto _ : state) benchmark::DoNotOptimize(render(*checked.scene, *checked.accel, settings));
}

void register_cases(const Catalogue& catalogue, const ComparisonPlan& plan) {
    for (auto& checked : checked_cases(catalogue, plan, "render")) {
        benchmark::RegisterBenchmark(row_name("render", *checked).c_str(),
                                     [checked, threads = plan.threads](benchmark::State& state) {
                                         time_render(state, *checked, threads);
                                     })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
}

}  // namespace
}  // namespace rayshoot

int main(int argc, char** argv) {
    return rayshoot::run_program("render", rayshoot::register_cases, argc, argv);
}
