#include "bench/timing/build_meter.h"

#include "bench/timing/clock.h"
#include "bench/timing/peak_memory.h"

#include <tbb/global_control.h>

namespace rayshoot {

MeasuredBuild timed_build(const Catalogue& catalogue, const std::string& spec,
                          const BuildInput& input, int threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(threads));
    MeasuredBuild made;
    const Stopwatch watch;
    made.accel = build(catalogue, spec, input);
    made.seconds = watch.seconds();
    return made;
}

MeasuredBuild measured_build(const Catalogue& catalogue, const std::string& spec,
                             const BuildInput& input, int threads) {
    const PeakMemory memory;
    MeasuredBuild made = timed_build(catalogue, spec, input, threads);
    made.peak_bytes = memory.risen();
    return made;
}

}  // namespace rayshoot
