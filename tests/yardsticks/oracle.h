#pragma once

#include "accel/core/catalogue.h"

#include <string>
#include <vector>

/// The yardsticks held against our own test of every primitive, in order.
namespace rayshoot::yardsticks {

/// All answers of a spec to rays, in batches of at most `batch`.
std::vector<Hit> closest(const Accel& accel, const std::vector<Ray>& rays, RayKind kind,
                         std::size_t batch = default_batch);
std::vector<std::uint8_t> occluded(const Accel& accel, const std::vector<Ray>& rays, RayKind kind,
                                   std::size_t batch = default_batch);

/// How answers compare with brute force's.
struct Comparison {
    std::size_t rays = 0;
    std::size_t hits = 0;  ///< by brute force
    std::size_t ambiguous =
        0;  ///< moving the ray by the tolerance changes brute force's own answer
    std::size_t differences = 0;
    std::string first;  ///< the first difference, in hex floats
};

/// t within `tolerance` of brute force's (relative, and of the ray's distance to the scene), hit or
/// miss alike. A ray is ambiguous if one of eight rays beside it, by that much, is answered
/// otherwise.
Comparison compare(const Geometry& geometry, const std::vector<Ray>& rays,
                   const std::vector<Hit>& answers, float tolerance);

}  // namespace rayshoot::yardsticks
