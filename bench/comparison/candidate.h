#pragma once

#include "bench/comparison/plan.h"
#include "bench/output/progress.h"

#include <memory>

namespace rayshoot {

/// A structure that was asked for, built over a scene, or the reason why it was not.
struct Candidate {
    std::string spec;   ///< canonical once built
    std::string given;  ///< as the user wrote it
    Agreement agreement = Agreement::exact;
    std::unique_ptr<Accel> accel;            ///< null: see refusal or error
    std::vector<double> build_samples;       ///< seconds
    std::vector<std::uint64_t> build_peaks;  ///< bytes, of those builds where it could be measured
    std::string refusal, error;

    bool is_oracle() const { return spec == oracle_spec; }
};

/// Builds it once, with `threads` threads.
Candidate make_candidate(const Catalogue& catalogue, const std::string& spec,
                         const BuildInput& input, int threads);

/// All structures of the plan, each built `plan.builds` times, in rounds of every structure once in
/// an order of its own; then as often as there are repetitions, while a structure's builds are
/// quick.
std::vector<Candidate> make_candidates(const Catalogue& catalogue, const ComparisonPlan& plan,
                                       const BuildInput& input, const std::string& scene,
                                       Progress& progress);

}  // namespace rayshoot
