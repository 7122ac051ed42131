#include "bench/comparison/contestant.h"

#include <algorithm>

namespace rayshoot {
namespace {

/// Primitives x rays that brute force is timed on in one pass: some 50 ms.
constexpr std::uint64_t oracle_tests_per_pass = 4000000;
constexpr std::size_t least_oracle_rays = 64;

std::vector<std::size_t> oracle_sample(const StreamContext& context) {
    const std::uint64_t primitives = std::max<std::uint64_t>(1, context.input.geometry.size());
    const std::size_t count =
        std::max<std::size_t>(least_oracle_rays, oracle_tests_per_pass / primitives);
    return spread_sample(context.stream.size(), count, context.plan.seed);
}

Row blank_row(const StreamContext& context, const Candidate& candidate, std::string family) {
    Row row;
    row.name = {std::move(family), context.stream.scene, candidate.spec,
                std::string(name_of(context.stream.kind))};
    row.agreement = candidate.agreement;
    row.primitives = context.input.geometry.size();
    row.threads = context.plan.threads;
    row.batch = context.plan.batch;
    row.rays = row.timed_rays = context.stream.size();
    row.build_samples = candidate.build_samples;
    row.build_peaks = candidate.build_peaks;
    if (candidate.accel) row.footprint = candidate.accel->footprint();
    row.refusal = candidate.refusal;
    if (context.stream.size() == 0) row.refusal = "the scene gives no rays of this kind";
    row.error = candidate.error;
    return row;
}

/// Judged and counted; without a tracer when it must not be timed.
void qualify(const StreamContext& context, const Candidate& candidate, const Gate& gate,
             Contestant& contestant) {
    if (!candidate.accel || context.stream.size() == 0) return;
    Row& row = contestant.row;
    const RayStream* timed = &context.stream;
    if (candidate.is_oracle()) {
        const auto chosen = oracle_sample(context);
        contestant.part = selection(context.stream, chosen);
        timed = &contestant.part;
        row.timed_rays = chosen.size();
        row.verdict = gate.judge_sample(*candidate.accel, candidate.agreement, chosen);
    } else {
        row.verdict = gate.judge(*candidate.accel, candidate.agreement);
    }
    if (!row.verdict.passed) {
        row.error = row.verdict.reason;
        return;
    }
    row.counts = count_stream(*candidate.accel, *timed, context.plan.batch);
    contestant.tracer = std::make_unique<StreamTracer>(
        *candidate.accel, *timed, TraceSettings{context.plan.threads, context.plan.batch});
}

}  // namespace

std::list<Contestant> contestants_of(const StreamContext& context,
                                     const std::vector<Candidate>& candidates, const Gate& gate,
                                     Progress& progress) {
    std::list<Contestant> contestants;
    for (const Candidate& candidate : candidates) {
        for (const char* family : {"rays", "warm"}) {
            if (family == std::string("warm") && !context.plan.warm) continue;
            Row row = blank_row(context, candidate, family);
            RowName as_given = row.name;
            as_given.spec = candidate.given;
            if (!context.plan.wants(to_string(row.name)) &&
                !context.plan.wants(to_string(as_given))) {
                continue;
            }
            progress.advance("check " + to_string(row.name));
            Contestant& contestant = contestants.emplace_back();
            contestant.row = std::move(row);
            qualify(context, candidate, gate, contestant);
        }
    }
    return contestants;
}

double time_once(Contestant& contestant) {
    StreamTracer& tracer = *contestant.tracer;
    if (contestant.row.name.family != "warm") return tracer.trace_fresh();
    if (contestant.row.samples.empty()) tracer.trace_fresh();
    return tracer.trace_warm();
}

Gate make_gate(const StreamContext& context) {
    GateSettings settings;
    settings.seed = context.plan.seed;
    settings.trace.threads = context.plan.gate_threads;
    return Gate(context.catalogue, context.input, context.stream, settings);
}

}  // namespace rayshoot
