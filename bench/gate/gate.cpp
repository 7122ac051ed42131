#include "bench/gate/gate.h"

#include "bench/gate/tolerance.h"
#include "bench/streams/promises.h"

#include <algorithm>

namespace rayshoot {
namespace {

std::size_t rays_for_the_oracle(const BuildInput& input, const RayStream& stream,
                                const GateSettings& settings) {
    const std::uint64_t primitives = std::max<std::uint64_t>(1, input.geometry.size());
    const std::uint64_t affordable = settings.affordable_tests / primitives;
    if (stream.size() <= affordable) return stream.size();
    const std::uint64_t bearable =
        std::max<std::uint64_t>(settings.most_tests / primitives, settings.least_rays);
    return std::min({stream.size(), settings.sample_rays, static_cast<std::size_t>(bearable)});
}

}  // namespace

Gate::Gate(const Catalogue& catalogue, const BuildInput& input, const RayStream& stream,
           const GateSettings& settings)
    : input_(input), stream_(stream), settings_(settings) {
    sample_ =
        spread_sample(stream.size(), rays_for_the_oracle(input, stream, settings), settings.seed);
    reference_accel_ = build(catalogue, reference_spec, input);
    const auto oracle = build(catalogue, oracle_spec, input);
    broken_ = broken_promise_in(input, stream);
    if (!broken_.empty()) return;
    StreamTracer tracer(*reference_accel_, stream, settings.trace);
    tracer.trace_fresh();
    reference_ = tracer.answers();
    compare_with_oracle(*oracle);
}

void Gate::compare_with_oracle(const Accel& oracle) {
    const RayStream part = selection(stream_, sample_);
    StreamTracer tracer(oracle, part, settings_.trace);
    tracer.trace_fresh();
    const Differences found = exact_differences(part, reference_, tracer.answers(), sample_);
    if (found.count == 0) return;
    broken_ = std::string(reference_spec) + " itself differs from " + std::string(oracle_spec) +
              " on " + std::to_string(found.count) + " rays, first " + describe(*found.first);
}

Verdict Gate::judge(const Accel& accel, Agreement agreement) const {
    if (!broken_.empty()) return {false, broken_, 0, 0, {}};
    StreamTracer tracer(accel, stream_, settings_.trace);
    tracer.trace_fresh();
    Verdict result = verdict(stream_, tracer, agreement, {});
    result.digest = tracer.answers().digest();
    if (result.passed && agreement == Agreement::exact && result.digest != reference_.digest()) {
        result.passed = false;
        result.reason = "answers equal the reference's one by one, but their digest does not";
    }
    return result;
}

Verdict Gate::judge_sample(const Accel& accel, Agreement agreement,
                           const std::vector<std::size_t>& chosen) const {
    if (!broken_.empty()) return {false, broken_, 0, 0, {}};
    const RayStream part = selection(stream_, chosen);
    StreamTracer tracer(accel, part, settings_.trace);
    tracer.trace_fresh();
    return verdict(part, tracer, agreement, chosen);
}

Verdict Gate::verdict(const RayStream& stream, const StreamTracer& tracer, Agreement agreement,
                      const std::vector<std::size_t>& chosen) const {
    Verdict result{false, {}, stream.size(), 0, {}};
    Differences differences;
    double allowed = 0;
    if (agreement == Agreement::exact) {
        differences = exact_differences(stream, reference_, tracer.answers(), chosen);
    } else {
        const ToleranceResult judged = tolerance_differences(
            *reference_accel_, input_.geometry, stream, reference_, tracer.answers(), chosen);
        differences = judged.unexplained;
        result.ambiguous = judged.ambiguous;
        allowed = unexplained_allowed * static_cast<double>(stream.size());
    }
    if (tracer.declined() > 0) {
        result.reason = std::to_string(tracer.declined()) + " rays were declined and got no answer";
    } else if (static_cast<double>(differences.count) > allowed) {
        result.reason = std::to_string(differences.count) + " of " + std::to_string(stream.size()) +
                        " rays differ, first " + describe(*differences.first);
    }
    result.passed = result.reason.empty();
    return result;
}

}  // namespace rayshoot
