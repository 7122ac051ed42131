#include "accel/bvh8/bvh8.h"

#include "accel/bvh8/layout.h"

namespace rayshoot::inline RAYSHOOT_ISA {

template <class Node>
WideBvh<Node>::WideBvh(const BuildInput& input, const Options& chosen) {
    const BinaryTree tree = build_tree(
        input.geometry.all_bounds(),
        {.build = chosen_build(chosen),
         .sah = {.bins = chosen.integer("bins", 2, BinnedSah::most_bins),
                 .largest_leaf = static_cast<std::uint32_t>(chosen.integer("leaf", 1, 32)),
                 .deepest = Stack::deepest,
                 .test_width = TriangleBlock::width}});
    WideTree<Node> wide = laid_out<Node>(input.geometry, tree);
    nodes_ = std::move(wide.nodes);
    leaves_ = std::move(wide.leaves);
    firsts_ = {reinterpret_cast<const std::byte*>(nodes_.data()), leaves_.first()};
    footprint_ = {.interior = nodes_.size(),
                  .leaves = tree.leaves,
                  .empty_leaves = 0,
                  .references = tree.order.size(),
                  .depth = static_cast<std::uint64_t>(tree.depth),
                  .bytes = nodes_.size() * sizeof(Node) + leaves_.bytes()};
    packets_ = chosen.flag("packets");
    most_apart_ = input.geometry.bounds().size() * 0.125f;
    in_flight_ = static_cast<std::size_t>(chosen.integer("flight", 1, most_flights));
}

template WideBvh<WideNode8>::WideBvh(const BuildInput& input, const Options& chosen);
template WideBvh<WideNode4>::WideBvh(const BuildInput& input, const Options& chosen);
template WideBvh<WideNode8q>::WideBvh(const BuildInput& input, const Options& chosen);

}  // namespace rayshoot::inline RAYSHOOT_ISA
