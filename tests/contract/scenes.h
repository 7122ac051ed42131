#pragma once

#include "accel/core/build_input.h"

#include <string>
#include <string_view>
#include <vector>

/// The hard scenes: small geometry on which structures that are nearly right go wrong.
namespace rayshoot::contract {

struct HardScene {
    std::string name;
    Geometry geometry;
    View view;
    std::vector<Light> lights;
    Hierarchy hierarchy;

    /// Everything a structure may be built from.
    BuildInput input() const { return {geometry, view, lights, &hierarchy}; }
};

/// One line of a table: how the primitives of a scene are made.
struct Recipe {
    std::string_view name;
    void (*fill)(GeometryBuilder&);
};

std::vector<Recipe> plain_scenes();
std::vector<Recipe> coincident_scenes();
std::vector<Recipe> extreme_scenes();
std::vector<Recipe> flat_scenes();
std::vector<Recipe> uneven_scenes();
std::vector<Recipe> skinny_scenes();
std::vector<Recipe> curved_scenes();
std::vector<Recipe> moving_scenes();

/// All of the above, in a fixed order.
std::vector<Recipe> hard_scenes();

/// Builds the geometry and puts a camera, lights of most kinds and a hierarchy round it.
HardScene hard_scene(const Recipe& recipe, Precision precision);

}  // namespace rayshoot::contract
