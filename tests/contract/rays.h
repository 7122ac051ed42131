#pragma once

#include "tests/contract/random.h"
#include "tests/contract/scenes.h"

#include <array>
#include <string_view>
#include <vector>

/// The hard rays: those on which structures that are nearly right go wrong.
namespace rayshoot::contract {

/// Three points of a primitive's surface and the time at which they are there.
struct Face {
    std::array<vec3, 3> corners{vec3(0), vec3(1, 0, 0), vec3(0, 1, 0)};
    float time = 0;

    vec3 point(float u, float v) const;  ///< the corners are (0,0), (1,0) and (0,1)
    vec3 random_point(Random& random) const;
    vec3 normal() const;  ///< unit length, or zero where the corners are on a line
};

/// A face of a primitive picked at random; an arbitrary one when there is no primitive.
Face random_face(const Geometry& geometry, Random& random);

/// The largest extent of the scene, or 1.
float scene_size(const Geometry& geometry);

/// One line of a table: a way of making rays.
struct RayFamily {
    std::string_view name;
    Ray (*make)(const Geometry&, Random&);
};

std::vector<RayFamily> aimed_families();   ///< at, along, in and from features of the surface
std::vector<RayFamily> axis_families();    ///< zero components, planes of boxes, diagonals
std::vector<RayFamily> remote_families();  ///< far origins, long and short directions, odd times

/// Rays that must be answered by a miss without a test.
std::vector<Ray> invalid_rays();

/// The same rays with t_min or t_max one float before, at and after the hit that each has.
std::vector<Ray> limited_rays(std::span<const Ray> rays, std::span<const Hit> hits, Random& random,
                              std::size_t at_most);

/// Rays of one kind, with the promises that go with them.
struct SourcedRays {
    std::vector<Ray> rays;
    std::vector<Source> source;
};

/// A few for each cell, border included, in raster order; edges and corners of cells too.
SourcedRays camera_rays(const View& view, Random& random);

/// From points on (and off) the surface to samples of every light.
SourcedRays shadow_rays(const HardScene& scene, Random& random, std::size_t count);

}  // namespace rayshoot::contract
