#include "accel/octree/octree.h"

#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

OctreeTraversal chosen_traversal(const Options& chosen) {
    return chosen.choice<OctreeTraversal>("traversal",
                                          {{"wide", OctreeTraversal::wide},
                                           {"glassner84", OctreeTraversal::glassner84},
                                           {"samet89", OctreeTraversal::samet89},
                                           {"recursive93", OctreeTraversal::recursive93},
                                           {"parametric", OctreeTraversal::parametric}});
}

Overlap chosen_overlap(const Options& chosen) {
    return chosen.choice<Overlap>("overlap", {{"auto", Overlap::bounds},
                                              {"bounds", Overlap::bounds},
                                              {"exact", Overlap::exact},
                                              {"havran", Overlap::havran},
                                              {"loose", Overlap::bounds}});
}

/// overlap=auto: the fastest that the traversal can do.
bool is_loose(const Options& chosen) {
    const std::string_view overlap = chosen.text("overlap");
    return overlap == "loose" ||
           (overlap == "auto" && chosen_traversal(chosen) == OctreeTraversal::wide);
}

OctreeSettings chosen_settings(const Options& chosen) {
    return {.depth = chosen.integer("depth", 0, OctreeLattice::most_levels),
            .largest_leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 64)),
            .planes = chosen.choice<OctreePlanes>(
                "planes", {{"centre", OctreePlanes::centre}, {"sah", OctreePlanes::sah}}),
            .stop = chosen.choice<OctreeStop>(
                "stop", {{"count", OctreeStop::count}, {"cost", OctreeStop::cost}}),
            .loose = is_loose(chosen),
            .most_references = chosen.number("bound", 1, 100000)};
}

bool is_linear(const Options& chosen) {
    return chosen.choice<bool>("storage", {{"nodes", false}, {"linear", true}});
}

OctreeLeafTest chosen_test(const Options& chosen) {
    return chosen.choice<OctreeLeafTest>(
        "leaves", {{"packed", OctreeLeafTest::packed}, {"single", OctreeLeafTest::single}});
}

/// What does not go together.
void refuse(const Options& chosen) {
    const bool wide = chosen_traversal(chosen) == OctreeTraversal::wide;
    const OctreeSettings settings = chosen_settings(chosen);
    if (wide && (is_linear(chosen) || chosen_test(chosen) == OctreeLeafTest::single))
        throw std::invalid_argument(
            "structure octree: traversal=wide has nodes and packed leaves of its own; "
            "storage=linear and leaves=single go with glassner84, samet89, recursive93 or "
            "parametric");
    if (settings.loose && !wide)
        throw std::invalid_argument(
            "structure octree: with overlap=loose, objects stand out of their cells, so it goes "
            "with traversal=wide");
    if (is_linear(chosen) && settings.planes == OctreePlanes::sah)
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
    : traversal_(chosen_traversal(chosen)),
      from_origin_(chosen.choice<bool>("from", {{"t_min", false}, {"origin", true}})) {
    refuse(chosen);
    const OctreeSettings settings = chosen_settings(chosen);
    const Membership membership(input, chosen_overlap(chosen));
    space_ = membership.space();
    if (membership.overlap() == Overlap::exact) exact_ = membership;
    OctreeGrowth growth = grow_octree(input.geometry.size(), membership, settings);
    footprint_ = footprint_of(growth, settings);
    if (traversal_ == OctreeTraversal::wide)
        keep_wide(input.geometry,
                  wide_octree(input.geometry, growth.root, membership, settings.loose), chosen);
    else keep_cells(input.geometry, growth.root, chosen);
}

void Octree::keep_wide(const Geometry& geometry, WideOctree&& octree, const Options& chosen) {
    wide_.emplace(geometry, std::move(octree.tree), chosen.flag("packets"),
                  chosen.integer("flight", 1, Wide::most_flights));
    outlines_ = std::move(octree.outlines);
    footprint_.bytes = *wide_->footprint().bytes + outlines_.bytes();
}

void Octree::keep_cells(const Geometry& geometry, OctreeCell& root, const Options& chosen) {
    OctreeLists lists;
    if (is_linear(chosen)) list_.emplace(root, lists);
    else nodes_.emplace(root, lists);
    if (exact_)
        outlines_ = OutlinedRuns(
            lists.leaves.size(), [&](std::size_t leaf) { return lists.leaves[leaf].count; },
            [&](std::size_t leaf) { return lists.bounds(geometry, leaf); });
    leaves_ = OctreeLeaves(geometry, std::move(lists), chosen_test(chosen));
    footprint_.bytes =
        (list_ ? list_->bytes() : nodes_->bytes()) + leaves_.bytes() + outlines_.bytes();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
