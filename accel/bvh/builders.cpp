#include "accel/bvh/builders.h"

#include "accel/bvh/hlbvh.h"
#include "accel/bvh/reinsertion.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr int bins_of_high = 64;

BinaryTree build_high(std::span<const Box> boxes, BinnedSah settings) {
    settings.bins = std::max(settings.bins, bins_of_high);
    settings.save_bins = false;
    BinaryTree tree = build_binned_sah(boxes, settings);
    reinsert(tree, {.deepest = settings.deepest});
    return tree;
}

}  // namespace

TreeBuild chosen_build(const Options& options) {
    return options.choice<TreeBuild>(
        "build",
        {{"fast", TreeBuild::fast}, {"default", TreeBuild::standard}, {"high", TreeBuild::high}});
}

BinaryTree build_tree(std::span<const Box> boxes, const TreeSettings& settings) {
    switch (settings.build) {
        case TreeBuild::fast:
            return build_hlbvh(boxes, settings.sah);
        case TreeBuild::high:
            return build_high(boxes, settings.sah);
        case TreeBuild::standard:
            break;
    }
    return build_binned_sah(boxes, settings.sah);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
