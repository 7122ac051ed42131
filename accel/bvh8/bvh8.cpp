#include "accel/bvh8/bvh8.h"

#include "accel/bvh8/layout.h"
#include "accel/bvh8/wide_hlbvh.h"

namespace rayshoot::inline RAYSHOOT_ISA {

namespace {

WideTree build(const Geometry& geometry, const TreeSettings& settings) {
    if (settings.build == TreeBuild::fast) return build_wide_hlbvh(geometry, settings.sah);
    return laid_out(geometry, build_tree(geometry.all_bounds(), settings));
}

}  // namespace

Bvh8::Bvh8(const BuildInput& input, const Options& chosen) {
    WideTree tree =
        build(input.geometry,
              {.build = chosen_build(chosen),
               .sah = {.bins = chosen.integer("bins", 2, BinnedSah::most_bins),
                       .largest_leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 32)),
                       .deepest = Stack::deepest,
                       .test_width = TriangleBlock::width}});
    nodes_ = std::move(tree.nodes);
    leaves_ = std::move(tree.leaves);
    firsts_ = {reinterpret_cast<const std::byte*>(nodes_.data()), leaves_.first()};
    footprint_ = {.interior = nodes_.size(),
                  .leaves = tree.leaf_count,
                  .empty_leaves = 0,
                  .references = input.geometry.size(),
                  .depth = static_cast<std::uint64_t>(tree.depth),
                  .bytes = nodes_.size() * sizeof(WideNode) + leaves_.bytes()};
    packets_ = chosen.flag("packets");
    in_flight_ = static_cast<std::size_t>(chosen.integer("flight", 1, most_flights));
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
