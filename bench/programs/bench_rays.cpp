#include "bench/comparison/contestant.h"
#include "bench/programs/program.h"
#include "bench/streams/ray_file.h"
#include "bench/streams/record.h"
#include "data/scenes.h"

#include <benchmark/benchmark.h>

/// Rows rays/<scene>/<structure>/<kind>: passes over recorded rays, each on fresh sessions.
namespace rayshoot {
namespace {

/// A scene with its streams, and every structure over it; cases refer to it.
struct Stage {
    Catalogue catalogue;
    ComparisonPlan plan;
    Scene scene;
    std::vector<RayStream> streams;
    std::optional<BuildInput> input;
    std::vector<Candidate> candidates;
    std::vector<std::list<Contestant>> contestants;  ///< by stream
};

void time_row(benchmark::State& state, Contestant& contestant) {
    const std::string& reason =
        contestant.row.error.empty() ? contestant.row.refusal : contestant.row.error;
    if (!contestant.tracer) {
        state.SkipWithError(reason.c_str());
        return;
    }
    for (auto _ : state) time_once(contestant);
    state.counters["rays"] = static_cast<double>(contestant.row.timed_rays);
}

void judge_and_register(const std::shared_ptr<Stage>& stage, const RayStream& stream) {
    const StreamContext context{stage->catalogue, stage->plan, *stage->input, stream};
    const Gate gate = make_gate(context);
    Progress progress(stage->candidates.size());
    stage->contestants.push_back(contestants_of(context, stage->candidates, gate, progress));
    for (Contestant& contestant : stage->contestants.back()) {
        if (!contestant.row.refusal.empty() && stage->plan.rows.empty()) continue;
        benchmark::RegisterBenchmark(
            to_string(contestant.row.name).c_str(),
            [stage, &contestant](benchmark::State& state) { time_row(state, contestant); })
            ->UseRealTime()
            ->Unit(benchmark::kMillisecond);
    }
}

void set_up(const Catalogue& catalogue, const ComparisonPlan& plan, const std::string& scene) {
    auto stage = std::make_shared<Stage>();
    stage->catalogue = catalogue;
    stage->plan = plan;
    stage->scene = load_scene(scene);
    ImageFormat format = plan.format;
    if (plan.ray_files.empty()) {
        stage->streams = record_streams(catalogue, stage->scene, plan.kinds, format);
    } else {
        stage->streams.push_back(read_ray_file(plan.ray_files.front()));
        stage->streams.front().scene = stage->scene.name;
        format = format_of(stage->streams.front(), format);
    }
    stage->input.emplace(build_input(stage->scene, format));
    for (const std::string& spec : plan.structures) {
        stage->candidates.push_back(make_candidate(catalogue, spec, *stage->input, plan.threads));
    }
    for (const RayStream& stream : stage->streams) judge_and_register(stage, stream);
}

void register_cases(const Catalogue& catalogue, const ComparisonPlan& plan) {
    if (plan.ray_files.size() > 1) throw std::invalid_argument("one --rays-file at a time");
    for (const std::string& scene : plan.scenes) set_up(catalogue, plan, scene);
}

}  // namespace
}  // namespace rayshoot

int main(int argc, char** argv) {
    return rayshoot::run_program("rays", rayshoot::register_cases, argc, argv);
}
