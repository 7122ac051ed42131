#pragma once

#include "accel/core/structure.h"

#include <numeric>

/// A partial structure that answers one ray at a time: it declines rays that run downward, after
/// having looked for their hit, so that their answer is half-finished when it is passed on.
namespace rayshoot::contract {

class Wary {
public:
    static constexpr std::string_view name = "wary";
    static constexpr std::string_view summary =
        "test only: partial, declines rays that run downward";
    static constexpr bool complete = false, remembers = false;
    static constexpr std::array<OptionInfo, 0> options{};
    static constexpr std::array<std::string_view, 2> configurations{"wary+bvh", "picky+wary+bvh"};
    struct Scratch {};

    Wary(const BuildInput& input, const Options&) : everything_{0, input.geometry.size()} {
        std::vector<std::uint32_t> order(input.geometry.size());
        std::iota(order.begin(), order.end(), 0u);
        leaves_ = Leaves(input.geometry, order, {&everything_, 1});
    }

    template <Query Q, Counter C>
    bool one(const Ray& ray, Source, Hit& hit, Scratch&, C& count) const {
        leaves_.template test<Q>(everything_, leaves_.prepared(ray), hit, count);
        return ray.direction.z >= 0;
    }
    Footprint footprint() const { return {.bytes = leaves_.bytes()}; }

private:
    LeafRange everything_;
    Leaves leaves_;
};

}  // namespace rayshoot::contract
