#include "tests/bvh/soups.h"

#include <cmath>
#include <random>

namespace rayshoot::bvh_test {
namespace {

Box around(const vec3& centre, const vec3& half) { return {centre - half, centre + half}; }

std::vector<Box> scaled(std::vector<Box> boxes, const vec3& factor) {
    for (Box& box : boxes) box = {box.lo * factor, box.hi * factor};
    return boxes;
}

/// Each twice as far from the origin as the one before: the worst for the tree's depth.
std::vector<Box> doubling(std::size_t count) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const float at = std::ldexp(1.0f, static_cast<int>(i % 120) - 60);
        boxes.push_back(around(vec3(at), vec3(at / 8)));
    }
    return boxes;
}

}  // namespace

std::vector<Box> random_boxes(std::size_t count, float size, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> place(0, 1), edge(0, size / 2);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const vec3 centre(place(random), place(random), place(random));
        boxes.push_back(around(centre, {edge(random), edge(random), edge(random)}));
    }
    return boxes;
}

std::vector<Soup> nasty_soups() {
    const std::vector<Box> many = random_boxes(3000, 0.05f, 7);
    std::vector<Box> unbounded = many;
    unbounded[17] = around(vec3(0), vec3(infinity));
    unbounded[18] = {vec3(0), vec3(1, 1, infinity)};
    std::vector<Box> mostly_coincident(1000, around(vec3(1), vec3(0.5f)));
    mostly_coincident[500] = around(vec3(9), vec3(0.5f));
    return {{"none", {}},
            {"one", random_boxes(1, 0.1f, 1)},
            {"two", random_boxes(2, 0.1f, 2)},
            {"five", random_boxes(5, 0.1f, 3)},
            {"many", many},
            {"large ones", random_boxes(3000, 2, 4)},
            {"coincident", std::vector<Box>(1000, around(vec3(1), vec3(0.5f)))},
            {"coincident points", std::vector<Box>(1000, Box{vec3(2), vec3(2)})},
            {"all but one coincident", mostly_coincident},
            {"a flat one", scaled(many, {1, 0, 1})},
            {"a line", scaled(many, {0, 1, 0})},
            {"tiny", scaled(many, vec3(0x1p-100f))},
            {"huge", scaled(many, vec3(0x1p60f))},
            {"too huge for areas", scaled(many, vec3(0x1p126f))},
            {"unbounded", unbounded},
            {"doubling", doubling(3000)}};
}

}  // namespace rayshoot::bvh_test
