#pragma once

namespace rayshoot {

/// A point of the unit square, [0, 1) each: what the maps of warp.h turn into places and
/// directions.
struct Pair {
    float u = 0, v = 0;
    bool operator==(const Pair&) const = default;
};

}  // namespace rayshoot
