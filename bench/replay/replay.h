#pragma once

#include "accel/core/catalogue.h"
#include "bench/replay/published_table.h"

#include <functional>

/// A published table rebuilt: every structure is built and every scene traced as the table says.
namespace rayshoot {

enum class ReplayVerdict : std::uint8_t {
    exact,   ///< the same number
    within,  ///< the tolerance
    pinned,  ///< no tolerance is promised; our number is the one that was recorded
    open,    ///< no tolerance is promised, and no number of ours was recorded
    off,     ///< outside the tolerance
    changed  ///< our number is not the one that was recorded
};
std::string_view verdict_name(ReplayVerdict verdict);
inline bool is_broken(ReplayVerdict verdict) {
    return verdict == ReplayVerdict::off || verdict == ReplayVerdict::changed;
}

struct ReplayedNumber {
    PublishedNumber published;
    double ours = 0;
    ReplayVerdict verdict = ReplayVerdict::open;
};

/// Called before each structure is built.
using ReplayProgress = std::function<void(const std::string& scene, const std::string& spec)>;

/// How many structures there are to build.
std::size_t rebuilds(const PublishedTable& table);

/// Counts as Havran 1999 did: 513 x 513 rays through pixel corners, five levels, his rules for
/// secondary and shadow rays. The numbers of one scene and spec are counted together. Throws
/// std::invalid_argument with file and line for a scene, spec or measure that there is not.
std::vector<ReplayedNumber> replay(const Catalogue& catalogue, const PublishedTable& table,
                                   const ReplayProgress& progress);

}  // namespace rayshoot
