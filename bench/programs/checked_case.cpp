#include "bench/programs/checked_case.h"

#include "bench/comparison/candidate.h"
#include "bench/comparison/row_name.h"
#include "bench/streams/random_rays.h"
#include "data/scenes.h"

namespace rayshoot {
namespace {

constexpr std::size_t checked_rays = 4096;

std::string reason_to_fail(const Catalogue& catalogue, const ComparisonPlan& plan,
                           const BuildInput& input, const Candidate& candidate) {
    if (!candidate.accel) {
        return candidate.error.empty() ? candidate.refusal : candidate.error;
    }
    const RayStream stream = hostile_rays(input.geometry, checked_rays, plan.seed);
    GateSettings settings;
    settings.trace.threads = plan.gate_threads;
    const Gate gate(catalogue, input, stream, settings);
    return gate.judge(*candidate.accel, candidate.agreement).reason;
}

}  // namespace

std::string row_name(const std::string& family, const CheckedCase& checked) {
    return to_string(RowName{family, checked.scene->name, checked.spec, ""});
}

std::vector<std::shared_ptr<CheckedCase>> checked_cases(const Catalogue& catalogue,
                                                        const ComparisonPlan& plan,
                                                        const std::string& family) {
    std::vector<std::shared_ptr<CheckedCase>> cases;
    for (const std::string& name : plan.scenes) {
        const auto scene = std::make_shared<const Scene>(load_scene(name));
        const BuildInput input = build_input(*scene, plan.format);
        for (const std::string& spec : plan.structures) {
            auto checked = std::make_shared<CheckedCase>();
            checked->scene = scene;
            checked->spec = spec;
            checked->format = plan.format;
            if (!plan.wants(row_name(family, *checked))) continue;
            Candidate candidate = make_candidate(catalogue, spec, input, plan.threads);
            if (!candidate.refusal.empty() && plan.rows.empty()) continue;
            checked->error = reason_to_fail(catalogue, plan, input, candidate);
            if (checked->error.empty()) checked->accel = std::move(candidate.accel);
            cases.push_back(std::move(checked));
        }
    }
    return cases;
}

}  // namespace rayshoot
