#include "accel/bvh8/bvh8.h"

#include "accel/bvh8/layout.h"
#include "accel/bvh8/wide_hlbvh.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {

namespace {

template <class Node>
WideTree<Node> build(const Geometry& geometry, const TreeSettings& settings) {
    if (settings.build == TreeBuild::fast) return build_wide_hlbvh<Node>(geometry, settings.sah);
    return laid_out<Node>(geometry, build_tree(geometry.all_bounds(), settings));
}

}  // namespace

template <class Node>
WideBvh<Node>::WideBvh(const BuildInput& input, const Options& chosen)
    : WideBvh(input.geometry,
              build<Node>(input.geometry,
                          {.build = chosen_build(chosen),
                           .sah = {.bins = chosen.integer("bins", 2, BinnedSah::most_bins),
                                   .largest_leaf =
                                       static_cast<std::uint32_t>(chosen.integer("leaf", 1, 32)),
                                   .deepest = Stack::deepest,
                                   .test_width = TriangleBlock::width}}),
              chosen.flag("packets"), chosen.integer("flight", 1, most_flights)) {}

template <class Node>
WideBvh<Node>::WideBvh(const Geometry& geometry, WideTree<Node>&& tree, bool packets, int in_flight)
    : nodes_(std::move(tree.nodes)),
      leaves_(std::move(tree.leaves)),
      packets_(packets),
      in_flight_(static_cast<std::size_t>(in_flight)) {
    firsts_ = {reinterpret_cast<const std::byte*>(nodes_.data()), leaves_.first()};
    footprint_ = {.interior = nodes_.size(),
                  .leaves = tree.leaf_count,
                  .empty_leaves = 0,
                  .references = geometry.size(),
                  .depth = static_cast<std::uint64_t>(tree.depth),
                  .bytes = nodes_.size() * sizeof(Node) + leaves_.bytes()};
    const vec3 size = geometry.bounds().size();
    most_apart_ = std::max({size.x, size.y, size.z}) / 8;
}

template WideBvh<WideNode8>::WideBvh(const BuildInput&, const Options&);
template WideBvh<WideNode8>::WideBvh(const Geometry&, WideTree<WideNode8>&&, bool, int);
template WideBvh<WideNode4>::WideBvh(const BuildInput&, const Options&);
template WideBvh<WideNode4>::WideBvh(const Geometry&, WideTree<WideNode4>&&, bool, int);
template WideBvh<WideNode8q>::WideBvh(const BuildInput&, const Options&);
template WideBvh<WideNode8q>::WideBvh(const Geometry&, WideTree<WideNode8q>&&, bool, int);

}  // namespace rayshoot::inline RAYSHOOT_ISA
