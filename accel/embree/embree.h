#pragma once

#include "accel/core/catalogue.h"

/// Intel Embree behind the structure interface: the yardstick of speed.
namespace rayshoot::inline RAYSHOOT_ISA {

StructureEntry embree_entry();

/// Embree's version and the instruction set it is pinned to, next to ours; for --version and
/// reports.
std::string embree_description();

/// For rows of this geometry: how many primitives Embree does not know and our own test answers for
/// ("6084 of 8281 primitives by our own test"); "" when there are none.
std::string embree_remark(const Geometry& geometry);

}  // namespace rayshoot::inline RAYSHOOT_ISA
