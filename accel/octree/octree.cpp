#include "accel/octree/octree.h"

#include "accel/octree/wide.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

OctreeSettings chosen_settings(const Options& chosen) {
    return {.depth = chosen.integer("depth", 0, Lattice::most_levels),
            .largest_leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 64)),
            .planes = chosen.choice<OctreePlanes>(
                "planes", {{"centre", OctreePlanes::centre}, {"sah", OctreePlanes::sah}}),
            .stop = chosen.choice<OctreeStop>(
                "stop", {{"count", OctreeStop::count}, {"cost", OctreeStop::cost}}),
            .most_references = chosen.number("references", 1, 100000)};
}

OctreeTraversal chosen_traversal(const Options& chosen) {
    return chosen.choice<OctreeTraversal>("traversal",
                                          {{"wide", OctreeTraversal::wide},
                                           {"glassner84", OctreeTraversal::glassner84},
                                           {"samet89", OctreeTraversal::samet89},
                                           {"recursive93", OctreeTraversal::recursive93},
                                           {"parametric", OctreeTraversal::parametric}});
}

Overlap chosen_overlap(const Options& chosen) {
    return chosen.choice<Overlap>(
        "overlap",
        {{"bounds", Overlap::bounds}, {"exact", Overlap::exact}, {"havran", Overlap::havran}});
}

/// What does not go together.
void refuse(bool linear, bool scalar, OctreeTraversal traversal, OctreePlanes planes) {
    if (traversal == OctreeTraversal::wide && (linear || scalar))
        throw std::invalid_argument(
            "structure octree: traversal=wide has nodes and packed leaves of its own; "
            "storage=linear "
            "and leaves=scalar go with glassner84, samet89, recursive93 or parametric");
    if (linear && planes == OctreePlanes::sah)
        throw std::invalid_argument(
            "structure octree: storage=linear knows cells by their place among equal ones, so it "
            "goes with planes=centre");
}

void describe(const OctreeCell& cell, Footprint& footprint) {
    if (cell.interior()) {
        ++*footprint.interior;
        for (const OctreeCell& child : *cell.children) describe(child, footprint);
        return;
    }
    ++*footprint.leaves;
    *footprint.empty_leaves += cell.members.empty();
    *footprint.references += cell.members.size();
    *footprint.depth = std::max(*footprint.depth, static_cast<std::uint64_t>(cell.lattice.level));
}

Footprint footprint_of(const OctreeGrowth& growth, const OctreeSettings& settings) {
    Footprint footprint{.interior = 0, .leaves = 0, .empty_leaves = 0, .references = 0, .depth = 0};
    describe(growth.root, footprint);
    if (growth.held_back > 0)
        footprint.remark = "stopped splitting " + std::to_string(growth.held_back) +
                           " cells: references are bounded by " +
                           std::to_string(static_cast<int>(settings.most_references)) +
                           " for each primitive";
    return footprint;
}

}  // namespace

Octree::Octree(const BuildInput& input, const Options& chosen)
    : traversal_(chosen_traversal(chosen)) {
    const bool linear = chosen.choice<bool>("storage", {{"nodes", false}, {"linear", true}});
    const auto test = chosen.choice<OctreeLeafTest>(
        "leaves", {{"packed", OctreeLeafTest::packed}, {"scalar", OctreeLeafTest::scalar}});
    const OctreeSettings settings = chosen_settings(chosen);
    refuse(linear, test == OctreeLeafTest::scalar, traversal_, settings.planes);
    const bool packets = chosen.flag("packets");
    const int flight = chosen.integer("flight", 1, Wide::most_flights);

    const Overlap overlap = chosen_overlap(chosen);
    const Membership membership(input, overlap);
    space_ = membership.space();
    if (overlap == Overlap::exact) exact_ = membership;
    OctreeGrowth growth = grow_octree(input.geometry.size(), membership, settings);
    footprint_ = footprint_of(growth, settings);
    if (traversal_ == OctreeTraversal::wide) {
        wide_.emplace(input.geometry, wide_octree(input.geometry, growth.root, membership), packets,
                      flight);
        footprint_.bytes = wide_->footprint().bytes;
        return;
    }
    OctreeLists lists;
    if (linear) list_.emplace(growth.root, lists);
    else nodes_.emplace(growth.root, lists);
    leaves_ = OctreeLeaves(input.geometry, std::move(lists), test);
    footprint_.bytes = (linear ? list_->bytes() : nodes_->bytes()) + leaves_.bytes();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
