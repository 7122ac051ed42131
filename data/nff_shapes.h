#pragma once

#include "data/scene.h"
#include "data/tokens.h"

#include <vector>

/// The entities of NFF that AFF shares: what follows each one's keyword. Each refuses what it
/// cannot read, with the line and what it should be.
namespace rayshoot {

/// `v`: fields in any order; sets the camera's pose, angle, hither and resolution.
void read_view(Tokens& tokens, Camera& camera);

/// `f`: red green blue Kd Ks shine T index_of_refraction.
Material read_fill(Tokens& tokens);

/// NFF marks what is seen from the inside only by negative radii; here everything is two-sided.
Sphere read_sphere(Tokens& tokens);
Frustum read_cone(Tokens& tokens);

struct Outline {
    std::vector<vec3> corners;
    std::vector<vec3> normals;  ///< empty, or one per corner
};
Outline read_polygon(Tokens& tokens);  ///< `p`
Outline read_patch(Tokens& tokens);    ///< `pp`

/// How many things of at least `shortest` characters each may still follow: a declared count
/// beyond it is a lie, and is refused before anything is allocated.
std::int64_t most_to_come(const Tokens& tokens, std::int64_t shortest);

float at_least_zero(Tokens& tokens, std::string_view use);

}  // namespace rayshoot
