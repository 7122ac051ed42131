#pragma once

#include "tracer/sampling/pair.h"
#include "tracer/sampling/strata.h"

namespace rayshoot {

/// A lamp cut into equal parts, so that several shadow rays of one hit go to different ones.
struct LampParts {
    int across = 1, down = 1;

    /// The most nearly square parts, `count` >= 1 in all.
    static LampParts of(int count) {
        const auto down = static_cast<int>(smaller_factor(static_cast<std::uint32_t>(count)));
        return {count / down, down};
    }
    int count() const { return across * down; }
    /// A point of the unit square as a point of one part of it.
    Pair within(int part, Pair pair) const {
        const auto column = static_cast<float>(part % across);
        const auto row = static_cast<float>(part / across);
        return {(column + pair.u) / static_cast<float>(across),
                (row + pair.v) / static_cast<float>(down)};
    }
};

}  // namespace rayshoot
