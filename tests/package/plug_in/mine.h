#pragma once

#include "accel/core/structure.h"

#include <numeric>

/// Every object, unless the ray misses the box round them all.
class Mine {
public:
    static constexpr std::string_view name = "mine";
    static constexpr std::string_view summary = "one box round everything";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array<rayshoot::OptionInfo, 0> options{};
    static constexpr std::array<std::string_view, 1> configurations{"mine"};
    struct Scratch {};

    Mine(const rayshoot::BuildInput& input, const rayshoot::Options&)
        : box_(input.geometry.bounds()), everything_{0, input.geometry.size()} {
        std::vector<std::uint32_t> order(input.geometry.size());
        std::iota(order.begin(), order.end(), 0u);
        leaves_ = rayshoot::Leaves(input.geometry, order, {&everything_, 1});
    }

    template <rayshoot::Query Q, rayshoot::Counter C>
    bool one(const rayshoot::Ray& ray, rayshoot::Source, rayshoot::Hit& hit, Scratch&,
             C& count) const {
        const rayshoot::TestRay test_ray = leaves_.prepared(ray);
        count(rayshoot::Event::bounding_volume_test);
        if (!clip(test_ray, box_).empty())
            leaves_.template test<Q>(everything_, test_ray, hit, count);
        return true;
    }

    rayshoot::Footprint footprint() const {
        return {.references = leaves_.size(), .bytes = leaves_.bytes()};
    }

private:
    rayshoot::Box box_;
    rayshoot::LeafRange everything_;
    rayshoot::Leaves leaves_;
};
