#pragma once

#include "accel/core/catalogue.h"

/// CGAL's AABB_tree behind the structure interface: the yardstick of exactness in plain double.
/// A build that holds it is GPL-3 as a whole (README).
namespace rayshoot::inline RAYSHOOT_ISA {

StructureEntry cgal_entry();

/// CGAL's version and licence; for --version and reports.
std::string cgal_description();

}  // namespace rayshoot::inline RAYSHOOT_ISA
