#pragma once

#include "accel/grid/resolution.h"
#include "accel/space/membership.h"

namespace rayshoot::inline RAYSHOOT_ISA {

/// The density, among powers of two from 1/8 to 32, at which a grid of these primitives should cost
/// a ray least. A line that meets the box of the scene meets n a / A of n cells and r a / A of r
/// references on average, a and A being the areas of a cell and of the box; a cell costs 1 and a
/// reference `reference_cost`. How many references there are is counted on a sample.
double cheapest_density(const Membership& membership, const Resolution& resolution,
                        std::uint32_t primitives);

}  // namespace rayshoot::inline RAYSHOOT_ISA
