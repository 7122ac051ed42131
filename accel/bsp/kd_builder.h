#pragma once

#include "accel/bsp/kd_cell.h"
#include "accel/bsp/sketch.h"

/// kd-trees by the surface area heuristic, top down. In parallel; the same for any number of
/// threads.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Large cells are divided at the best of evenly spaced planes, small ones at the best of all.
BspSketch build_by_bins(const Geometry& geometry, const Membership& membership,
                        const KdSettings& settings);

/// All cells are divided at the best of all planes, by sweeping over presorted events (Wald &
/// Havran 2006).
BspSketch build_by_events(const Geometry& geometry, const Membership& membership,
                          const KdSettings& settings);

/// A reference to each primitive.
References all_references(const Geometry& geometry, const Membership& membership);

}  // namespace rayshoot::inline RAYSHOOT_ISA
