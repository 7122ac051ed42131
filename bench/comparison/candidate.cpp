#include "bench/comparison/candidate.h"

#include "bench/timing/clock.h"

#include <tbb/global_control.h>

#include <exception>

namespace rayshoot {
namespace {

constexpr double enough_seconds = 1;  // of building; a longer build needs no further sample

void build_repeatedly(const Catalogue& catalogue, const BuildInput& input, int threads,
                      int repetitions, Candidate& candidate) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    double spent = 0;
    for (int i = 0; i < repetitions && spent < enough_seconds; ++i) {
        candidate.accel.reset();
        const Stopwatch watch;
        candidate.accel = build(catalogue, candidate.given, input);
        candidate.build_samples.push_back(watch.seconds());
        spent += candidate.build_samples.back();
    }
}

}  // namespace

Candidate make_candidate(const Catalogue& catalogue, const std::string& spec,
                         const BuildInput& input, int threads, int repetitions) {
    Candidate candidate;
    candidate.spec = candidate.given = spec;
    candidate.agreement = agreement(catalogue, spec);
    candidate.refusal = refusal(catalogue, spec, input.geometry);
    if (!candidate.refusal.empty()) return candidate;
    try {
        build_repeatedly(catalogue, input, threads, repetitions, candidate);
        candidate.spec = candidate.accel->spec();
    } catch (const std::exception& failure) {
        candidate.accel.reset();
        candidate.build_samples.clear();
        candidate.error = std::string("cannot be built: ") + failure.what();
    }
    return candidate;
}

}  // namespace rayshoot
