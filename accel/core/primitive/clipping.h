#pragma once

#include "accel/core/box.h"

#include <span>

/// Flat shapes clipped to a box (Sutherland & Hodgman 1974), for build-time questions.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Bounds of the part of the flat shape inside the box, rounded outward; empty when there is none.
/// Conservative where the shape is concave: the bridges that clipping leaves are enclosed as well.
Box clipped_bounds(std::span<const dvec3> corners, const Box& box);

}  // namespace rayshoot::inline RAYSHOOT_ISA
