#pragma once

#include "accel/core/catalogue.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace rayshoot {

/// A structure, and what building it took.
struct MeasuredBuild {
    std::unique_ptr<Accel> accel;
    double seconds = 0;
    std::optional<std::uint64_t> peak_bytes;  ///< PeakMemory over the build
};

/// Builds with at most `threads` threads of oneTBB, which Embree builds with as well. Throws as
/// build does. Without peak_bytes.
MeasuredBuild timed_build(const Catalogue& catalogue, const std::string& spec,
                          const BuildInput& input, int threads);

/// The same with peak_bytes, and from memory that is fresh for everyone.
MeasuredBuild measured_build(const Catalogue& catalogue, const std::string& spec,
                             const BuildInput& input, int threads);

}  // namespace rayshoot
