#pragma once

#include "data/scene.h"

/// Surfaces that emit are lights, too.
namespace rayshoot {

/// Adds a light for everything whose material emits and that no light has among its primitives:
/// one of kind triangles for the triangles of a material that move as one, one of kind rectangle
/// for a polygon that is one, one of kind sphere for a sphere. Throws std::invalid_argument with
/// the primitive's number for other shapes that emit: no light is sampled there.
void add_emitters(Scene& scene);

/// Why a primitive could not be a light, with the remedy; empty if it can.
std::string not_a_light(const Geometry& geometry, std::uint32_t primitive);

/// Whether four corners make a rectangle, by rounding.
bool is_rectangle(std::span<const vec3> corners);

/// `light` shines from these primitives: where they are over the shutter bounds its samples.
void occupy(Light& light, const Geometry& geometry, std::vector<std::uint32_t> primitives);

}  // namespace rayshoot
