#include "accel/grid/grid.h"

#include "accel/core/primitive/padding.h"
#include "accel/grid/density.h"

#include <algorithm>
#include <stdexcept>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

enum class Nested : std::uint8_t { off, recursive, two_level };

Overlap chosen_overlap(const Options& chosen) {
    return chosen.choice<Overlap>(
        "overlap",
        {{"bounds", Overlap::bounds}, {"exact", Overlap::exact}, {"havran", Overlap::havran}});
}

LeafKind chosen_leaves(const Options& chosen) {
    const auto kind = chosen.choice<LeafKind>(
        "leaves", {{"packed", LeafKind::packed}, {"single", LeafKind::single}});
    if (chosen.flag("mailbox") && kind == LeafKind::packed)
        throw std::invalid_argument(
            "structure grid: option mailbox=on needs leaves=single: a block of objects costs as "
            "much whether one of them is new or all are");
    return kind;
}

/// With density=auto grids in cells have the density of Jevans & Wyvill's.
GridSettings chosen_settings(const Options& chosen, const Membership& membership,
                             std::uint32_t primitives) {
    constexpr double of_inner_grids = 3;
    const auto nested = chosen.choice<Nested>(
        "nested",
        {{"off", Nested::off}, {"recursive", Nested::recursive}, {"two_level", Nested::two_level}});
    const int depth = chosen.integer("depth", 2, 6);
    const Resolution resolution = Resolution::chosen(chosen, "resolution");
    const bool automatic = chosen.text("density") == "auto";
    const double density = automatic ? of_inner_grids : chosen.number("density", 0.01, 64);
    const double top = chosen.number("top", 0.001, 64);
    return {
        .resolution = resolution,
        .density = density,
        .top_density = nested == Nested::two_level ? top
                       : automatic ? cheapest_density(membership, resolution, primitives)
                                   : density,
        .levels = nested == Nested::off         ? 1
                  : nested == Nested::two_level ? 2
                                                : depth,
        .leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 1000)),
        .bound = chosen.number("bound", 1, 100000),
        .skip = chosen.choice<Skip>(
            "skip", {{"none", Skip::none}, {"macro", Skip::macro}, {"distance", Skip::distance}})};
}

/// Havran 1999 finds cells by rounding down, so that what begins at a plane is not in the cell
/// below it. Our stored bounds begin a rounding lower; as much lower are the planes. The margin of
/// Havran's box is larger than this, or else nothing is done.
float lowered_planes(const Geometry& geometry, const Box& space) {
    if (geometry.size() == 0) return 0;
    const float lowered = 4 * own_padding * largest_coordinate(space);
    return space.grown(-2 * lowered).contains(geometry.bounds()) ? lowered : 0;
}

OutlinedRuns outlined(const Geometry& geometry, const GridTree& tree) {
    const auto references = [&](std::size_t cell) {
        const CellWord word = tree.cells[cell];
        return word.is_leaf() ? tree.leaves[word.leaf()].count : 0;
    };
    const auto bounds = [&](std::size_t cell) {
        Box box;
        const LeafRange leaf = tree.leaves[tree.cells[cell].leaf()];
        for (std::uint32_t i = 0; i < leaf.count; ++i)
            box.include(geometry.bounds(tree.members[leaf.first + i]));
        return box;
    };
    return {tree.cells.size(), references, bounds};
}

}  // namespace

Grid::Grid(const BuildInput& input, const Options& chosen)
    : membership_(input, chosen_overlap(chosen)) {
    GridSettings settings = chosen_settings(chosen, membership_, input.geometry.size());
    if (chosen_overlap(chosen) == Overlap::havran)
        settings.lowered = lowered_planes(input.geometry, membership_.space());
    const LeafKind kind = chosen_leaves(chosen);
    skip_ = settings.skip;
    const bool lanes = kind == LeafKind::packed && skip_ != Skip::macro;
    GridTree tree = build_grid_tree(input, membership_, settings);
    if (!tree.grids.empty()) {
        const Lattice& outermost = tree.grids.front().lattice;
        space_ = {outermost.lo(), outermost.box(outermost.last()).hi};
        nearby_ = {space_.lo - Flock::most_cells_away * outermost.step(),
                   space_.hi + Flock::most_cells_away * outermost.step()};
        const bool in_range = lanes && finite(outermost.per_step());
        abreast_ = chosen.flag("abreast") && in_range;
        packets_ = chosen.flag("packets") && in_range;
        const vec3 size = space_.size();
        most_apart_ = std::max({size.x, size.y, size.z}) / 8;
    }
    const std::uint64_t leaves = tree.leaves.size(), references = tree.members.size();
    if (membership_.overlap() == Overlap::exact) outlines_ = outlined(input.geometry, tree);
    leaves_ = CellLeaves(input.geometry, kind, chosen.flag("mailbox"), tree);
    grids_ = std::move(tree.grids);
    cells_ = std::move(tree.cells);
    const std::uint64_t interior = grids_.empty() ? 0 : grids_.size() - 1;
    footprint_ = {.interior = interior,
                  .leaves = leaves + tree.empty_cells,
                  .empty_leaves = tree.empty_cells,
                  .references = references,
                  .depth = static_cast<std::uint64_t>(tree.depth),
                  .bytes = grids_.size() * sizeof(SubGrid) + cells_.size() * sizeof(CellWord) +
                           leaves_.bytes() + outlines_.bytes(),
                  .remark = tree.remark};
}

bool Grid::runs_in_a_plane(const Lattice& lattice, const SlabRay& ray) const {
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(ray.inverse[axis]) < infinity) && lattice.on_plane(axis, ray.origin[axis]))
            return true;
    return false;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
