#include "accel/brute_force/brute_force.h"

#include <numeric>

namespace rayshoot::inline RAYSHOOT_ISA {

BruteForce::BruteForce(const BuildInput& input, const Options&)
    : everything_{0, input.geometry.size()} {
    std::vector<std::uint32_t> order(input.geometry.size());
    std::iota(order.begin(), order.end(), 0u);
    leaves_ = Leaves(input.geometry, order, {&everything_, 1});
}

Footprint BruteForce::footprint() const {
    return {.interior = 0,
            .leaves = 1,
            .empty_leaves = leaves_.size() == 0,
            .references = leaves_.size(),
            .depth = 0,
            .bytes = leaves_.bytes()};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
