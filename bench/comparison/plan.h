#pragma once

#include "bench/gate/gate.h"
#include "bench/streams/ray_stream.h"
#include "tracer/camera.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

/// What a comparison measures: every structure on every stream of every scene.
namespace rayshoot {

struct ComparisonPlan {
    std::vector<std::string> scenes;
    std::vector<std::string> structures;  ///< specs
    std::vector<StreamKind> kinds{usual_stream_kinds.begin(), usual_stream_kinds.end()};
    std::vector<std::filesystem::path> ray_files;         ///< of the one scene; instead of kinds
    std::set<std::string> rows;                           ///< only these row names; empty: all
    ImageFormat format{384, 384, 1, Raster::centres, 0};  ///< that streams are recorded from
    int threads = 1;                                      ///< of what is timed, builds too
    int gate_threads = 1;
    int repetitions = 11;  ///< blocks, each with every structure once
    int builds = 3;        ///< of each structure, at least
    std::size_t batch = default_batch;
    bool adaptor_cost = false;  ///< measure what our interface costs Embree, too
    bool warm = false;          ///< rows on kept sessions as well
    double void_above = 0.05;   ///< a run whose control kernel moved further is void
    std::string protocol;       ///< what set the defaults (protocol.h); empty: none
    std::uint64_t seed = 1;

    bool wants(const std::string& row) const { return rows.empty() || rows.contains(row); }
};

/// Narrows a plan to the rows it names: their scenes, structures and kinds, each in order of first
/// mention. Does nothing when it names none. Throws std::invalid_argument for a name that is none.
void narrow_to_rows(ComparisonPlan& plan, const std::vector<std::string>& names);

/// Throws std::invalid_argument, saying what exists, for a structure or option there is not, and
/// for an empty plan.
void require_valid(const Catalogue& catalogue, const ComparisonPlan& plan);

}  // namespace rayshoot
