#pragma once

#include "accel/core/geometry.h"

#include <cstdint>
#include <random>
#include <vector>

/// Small scenes and rays for the yardsticks' tests; the same numbers on every machine.
namespace rayshoot::yardsticks {

/// Uniform in [0, 1), from the top 24 bits of a generator that the standard fixes.
class Random {
public:
    explicit Random(std::uint32_t seed) : generator_(seed) {}
    float next() { return static_cast<float>(generator_() >> 8) * 0x1p-24f; }
    float between(float lo, float hi) { return lo + (hi - lo) * next(); }
    vec3 in_cube(float half) {
        const float x = between(-half, half), y = between(-half, half);
        return {x, y, between(-half, half)};
    }
    /// Uniform on the unit sphere.
    vec3 on_sphere();

private:
    std::mt19937 generator_;
};

Geometry triangle_soup(int count, Precision precision = Precision::standard);
Geometry sphere_cloud(int count);
Geometry frustum_pile(int count);
Geometry polygon_pile(int count);
/// Triangles, spheres, frusta and polygons in turn, some of them moving.
Geometry everything(int count);
/// A closed surface of 8 * splits^2 triangles of radius about 1, bumpy.
Geometry bumpy_ball(int splits, Precision precision = Precision::standard);

/// From points on a sphere round the origin to points in a cube; times in [0, 1].
std::vector<Ray> inward_rays(std::size_t count, float distance, float half);

/// A pinhole view of the bumpy ball, 8 x 8 tiles of pixels in rows.
std::vector<Ray> camera_rays(int size);
/// One ray in a random direction (cosine law) from each point that a camera ray hits: `hits` answer
/// `rays`.
std::vector<Ray> diffuse_rays(const Geometry& geometry, const std::vector<Ray>& rays,
                              const std::vector<Hit>& hits);
/// One ray to a point light from each of them; origin + direction is the light.
std::vector<Ray> shadow_rays(const Geometry& geometry, const std::vector<Ray>& rays,
                             const std::vector<Hit>& hits);

}  // namespace rayshoot::yardsticks
