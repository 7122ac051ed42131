#pragma once

#include "accel/bsp/descend.h"
#include "accel/bsp/general/frame.h"
#include "accel/bsp/outlines.h"
#include "accel/core/structure.h"

/// Binary space partitioning by planes that may lie anyhow (Ize, Wald & Parker 2008), and by planes
/// across the axes where these are cheaper. Rays go alone. See ../README.md.
namespace rayshoot::inline RAYSHOOT_ISA {

class GeneralBsp {
public:
    static constexpr std::string_view name = "bsp_general";
    static constexpr std::string_view summary =
        "binary space partitioning by triangles' planes, and across the axes where cheaper";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array options{
        OptionInfo{"general", "0 to 4096", "32",
                   "cells with no more primitives are divided by any plane; 0: none is"},
        OptionInfo{"depth", "0 to 60", "0", "most levels; 0: 8 + 1.3 log2 N"},
        OptionInfo{"leaf", "0 to 64", "0",
                   "no cell with so few primitives is divided; 0: as SAH says"}};
    static constexpr std::array<std::string_view, 3> configurations{
        "bsp_general", "bsp_general:general=0", "bsp_general:general=4096,leaf=1,depth=60"};

    using Scratch = BspFlight;

    GeneralBsp(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    bool one(const Ray& ray, Source source, Hit& hit, Scratch& flight, C& count) const;
    Footprint footprint() const { return tree_.footprint; }

private:
    template <Query Q, Counter C>
    void trace(BspFlight& flight, C& count) const;

    Membership membership_;
    ObliqueFrame frame_;
    BspTree tree_;
    Outlines outlines_;  ///< of nothing where cells are good for every ray
};

template <Query Q, Counter C>
inline bool GeneralBsp::one(const Ray& ray, Source, Hit& hit, Scratch& flight, C& count) const {
    flight.start(ray, 0, tree_.leaves.precision(), membership_.space());
    const bool cells_are_good = membership_.overlap() != Overlap::exact ||
                                (membership_.made_for(ray) && ObliqueRay::ordinary(ray.direction));
    if (cells_are_good) trace<Q>(flight, count);
    else {
        const auto visit = [&](BspNode leaf) {
            visit_leaf<Q>(tree_.leaves, flight, leaf, count);
            return flight.over<Q>();
        };
        each_leaf(tree_, outlines_, flight.ray, ray.t_min, flight.hit, visit, count);
    }
    hit = flight.hit;
    return true;
}

template <Query Q, Counter C>
inline void GeneralBsp::trace(BspFlight& flight, C& count) const {
    const ObliqueRay ray(frame_, flight.ray.origin, flight.ray.direction);
    const auto meet = [&](BspNode node) {
        const std::uint32_t axis = node.axis();
        if (axis != oblique_axis) [[likely]]
            return BspMeeting{(node.plane() - flight.origin[axis]) * flight.inverse[axis],
                              flight.near_side[axis]};
        const ObliquePlane& plane = tree_.planes[node.number()];
        const float slope = ray.slope(plane);
        return BspMeeting{ray.at(plane, slope), std::signbit(slope)};
    };
    const auto visit = [&](BspNode leaf) { visit_leaf<Q>(tree_.leaves, flight, leaf, count); };
    descend<Q>(flight, tree_.nodes, meet, visit, count);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
