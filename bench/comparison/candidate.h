#pragma once

#include "bench/comparison/plan.h"

#include <memory>

namespace rayshoot {

/// A structure that was asked for, built over a scene, or the reason why it was not.
struct Candidate {
    std::string spec;   ///< canonical once built
    std::string given;  ///< as the user wrote it
    Agreement agreement = Agreement::exact;
    std::unique_ptr<Accel> accel;       ///< null: see refusal or error
    std::vector<double> build_samples;  ///< seconds
    std::string refusal, error;

    bool is_oracle() const { return spec == oracle_spec; }
    bool is_embree() const { return spec == "embree" || spec.starts_with("embree:"); }
};

/// Builds it on `threads` threads, again and again up to `repetitions` times while that is quick.
Candidate make_candidate(const Catalogue& catalogue, const std::string& spec,
                         const BuildInput& input, int threads, int repetitions = 1);

}  // namespace rayshoot
