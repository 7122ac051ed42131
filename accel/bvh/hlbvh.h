#pragma once

#include "accel/bvh/binned_sah.h"

namespace rayshoot::inline RAYSHOOT_ISA {

/// Pantaleoni & Luebke 2010, Garanzha et al. 2011: small sub-trees split by the bits of Morton
/// codes (Lauterbach et al. 2009), and above them a tree by binned SAH. In parallel, and the same
/// tree for any number of threads. Of the settings, the costs are not asked for below.
BinaryTree build_hlbvh(std::span<const Box> boxes, const BinnedSah& settings);

}  // namespace rayshoot::inline RAYSHOOT_ISA
