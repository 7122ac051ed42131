#pragma once

#include "accel/core/box.h"

#include <string>
#include <vector>

/// Boxes for builders of trees: what they meet, and what they should survive.
namespace rayshoot::bvh_test {

struct Soup {
    std::string name;
    std::vector<Box> boxes;
};

/// Boxes of edges up to `size`, with centres in the unit cube.
std::vector<Box> random_boxes(std::size_t count, float size, unsigned seed);

/// Of many shapes; small enough to be looked at one by one.
std::vector<Soup> nasty_soups();

}  // namespace rayshoot::bvh_test
