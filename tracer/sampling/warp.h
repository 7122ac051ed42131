#pragma once

#include <glm/vec2.hpp>

#include "accel/core/vec.h"
#include "tracer/sampling/pair.h"

/// Maps of the unit square onto the shapes that are sampled, each with its probability density.
/// They carry equal areas (of the density) to equal areas, so strata stay strata. Pure functions,
/// computed in double and rounded once; directions are unit vectors round +z.
namespace rayshoot {

/// Uniform on the unit disc: concentric squares become concentric circles (Shirley & Chiu 1997).
/// Never on the circle itself.
glm::vec2 concentric_disc(Pair pair);
/// Per area, of a point within the unit disc.
float disc_pdf();

/// Uniform on the regular polygon of `blades` >= 3 corners on the unit circle, the first one at
/// `angle` radians from +x towards +y. u is turn, v the square of the relative distance.
glm::vec2 regular_polygon(Pair pair, int blades, float angle);
/// Per area, of a point within the polygon.
float regular_polygon_pdf(int blades);

/// Density cos / pi per solid angle: the disc projected up (Malley). z is positive.
vec3 cosine_hemisphere(Pair pair);
/// Zero below the horizon.
float cosine_hemisphere_pdf(float cosine);

vec3 uniform_sphere(Pair pair);
float uniform_sphere_pdf();

/// Height 1 - cos of the unit sphere's cap within a cone of directions, from the squared sine of
/// its half-angle, (radius / distance)^2 for the cone that a sphere fills. `sine_squared` in [0,
/// 1]; exact for narrow cones, too, where 1 - cos is not.
double cap_height(double sine_squared);
/// Uniform per solid angle in the cone of `height` 1 - cos, in (0, 2].
vec3 uniform_cone(Pair pair, double height);
/// Of a direction within it.
float uniform_cone_pdf(double height);

/// Weights (of the second and third corner, as u, v) of a point uniform on a triangle, u + v <= 1
/// (Heitz 2019: continuous, and without a square root). Its density per area is 1 / area.
Pair uniform_triangle(Pair pair);

/// Phong's lobe: density (exponent + 1) / (2 pi) cos^exponent, of the angle with +z; z > 0 unless
/// it rounds to 0. `exponent` >= 0; 0 is the uniform hemisphere.
vec3 phong_lobe(Pair pair, float exponent);
/// Zero below the horizon.
float phong_lobe_pdf(float cosine, float exponent);

}  // namespace rayshoot
