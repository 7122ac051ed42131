#pragma once

#include "accel/bsp/general/part.h"
#include "accel/bsp/general/polyhedron.h"
#include "accel/bsp/kd_cell.h"

/// Where to divide a cell by a plane that may lie anyhow (Ize, Wald & Parker 2008).
namespace rayshoot::inline RAYSHOOT_ISA {

/// Up to so many primitives of a cell, evenly chosen, offer their planes.
inline constexpr std::size_t most_offering = 32;

/// Of an oblique node, where Sah::step_cost is that of one across an axis: it has a division and
/// two sums of three products instead of a difference and a product, and lies elsewhere in memory.
inline constexpr float oblique_step_cost = 1.5f;

struct GeneralSplit {
    float cost = infinity;  ///< infinite: it is best to have a leaf
    bool oblique = false;
    KdSplit axial{};       ///< unless it is oblique
    ObliquePlane plane{};  ///< if it is
};

/// The cheapest by SAH of the planes that primitives offer: those at the faces of their boxes, and
/// of flat primitives those beside them, and upright on them along their edges. In cells of more
/// than most_offering primitives only one across an axis is tried, the best by boxes.
GeneralSplit best_general_split(const Geometry& geometry, const KdParting& parting,
                                const PartMaker& maker, const KdCell& cell, const Polyhedron& hull,
                                std::span<const Part> parts);

/// The normals of the planes that a primitive at rest offers: its own, then outward those on its
/// edges. None where it is not flat, or has no area.
std::vector<vec3> offered_normals(const Geometry& geometry, std::uint32_t primitive);

}  // namespace rayshoot::inline RAYSHOOT_ISA
