#pragma once

#include "accel/core/catalogue.h"
#include "bench/limits/cost_model.h"

#include <string>
#include <vector>

/// What a step and a leaf cost where memory costs nothing, without looking into a structure.
namespace rayshoot {

struct CalibrationSettings {
    std::size_t most_bytes = 24 << 10;  ///< of the tree: it stays in the first-level cache
    std::size_t rays = 1 << 14;         ///< a stream
    int repetitions = 15;               ///< passes; the fastest counts
    std::uint64_t seed = 1;
};

/// Chords through small triangle soups, of spheres round them of several sizes, so that some rays
/// take many steps and leaves and others hardly any. Soups whose tree is larger than most_bytes are
/// left out. Throws std::invalid_argument for a structure that cannot count or tell its size.
std::vector<CostSample> calibrate(const Catalogue& catalogue, const std::string& spec,
                                  const CalibrationSettings& settings);

}  // namespace rayshoot
