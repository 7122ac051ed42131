#pragma once

#include "data/generators/printer.h"
#include "data/generators/transform.h"

/// Newell's teapot: 32 bicubic Bezier patches, z up, the bottom included; its bounds are about
/// [-3, 3.434] x [-2, 2] x [0, 3.15].
namespace rayshoot::procedural {

/// control[row][column]
using Patch = std::array<std::array<dvec3, 4>, 4>;

/// In the order of the SPD: rim, body, handle, spout, lid, bottom.
std::array<Patch, 32> newell_patches();

/// Prints each patch as 2 * size * size triangles with normals, but for those that shrink to a line
/// at the middle of lid or bottom: 64 size^2 - 8 size in all (56 for size 1).
void print_teapot(Printer& printer, int size);

}  // namespace rayshoot::procedural
