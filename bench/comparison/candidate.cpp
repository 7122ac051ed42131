#include "bench/comparison/candidate.h"

#include "bench/statistics/random.h"
#include "bench/timing/build_meter.h"

#include <algorithm>
#include <exception>
#include <numeric>

namespace rayshoot {
namespace {

constexpr double enough_seconds = 1;  // of building; a longer build gets no further samples

Candidate unbuilt(const Catalogue& catalogue, const std::string& spec, const BuildInput& input) {
    Candidate candidate;
    candidate.spec = candidate.given = spec;
    candidate.agreement = agreement(catalogue, spec);
    candidate.refusal = refusal(catalogue, spec, input.geometry);
    return candidate;
}

/// Once more; the last build's structure is freed before.
void build_again(const Catalogue& catalogue, const BuildInput& input, int threads,
                 Candidate& candidate) {
    if (!candidate.refusal.empty() || !candidate.error.empty()) return;
    candidate.accel.reset();
    try {
        MeasuredBuild made = measured_build(catalogue, candidate.given, input, threads);
        candidate.accel = std::move(made.accel);
        candidate.spec = candidate.accel->spec();
        candidate.build_samples.push_back(made.seconds);
        if (made.peak_bytes) candidate.build_peaks.push_back(*made.peak_bytes);
    } catch (const std::exception& failure) {
        candidate.build_samples.clear();
        candidate.build_peaks.clear();
        candidate.error = std::string("cannot be built: ") + failure.what();
    }
}

bool wants_round(const Candidate& candidate, const ComparisonPlan& plan, int round) {
    if (round < plan.builds) return true;
    const auto& samples = candidate.build_samples;
    return round < plan.repetitions &&
           std::accumulate(samples.begin(), samples.end(), 0.0) < enough_seconds;
}

}  // namespace

Candidate make_candidate(const Catalogue& catalogue, const std::string& spec,
                         const BuildInput& input, int threads) {
    Candidate candidate = unbuilt(catalogue, spec, input);
    build_again(catalogue, input, threads, candidate);
    return candidate;
}

std::vector<Candidate> make_candidates(const Catalogue& catalogue, const ComparisonPlan& plan,
                                       const BuildInput& input, const std::string& scene,
                                       Progress& progress) {
    std::vector<Candidate> candidates;
    for (const std::string& spec : plan.structures) {
        candidates.push_back(unbuilt(catalogue, spec, input));
    }
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Sequence random(plan.seed);
    for (int round = 0; round < std::max(plan.builds, plan.repetitions); ++round) {
        for (std::size_t i = order.size(); i > 1; --i)
            std::swap(order[i - 1], order[random.below(i)]);
        for (const std::size_t i : order) {
            if (round < plan.builds) progress.advance("build/" + scene + "/" + candidates[i].given);
            if (wants_round(candidates[i], plan, round))
                build_again(catalogue, input, plan.threads, candidates[i]);
        }
    }
    return candidates;
}

}  // namespace rayshoot
