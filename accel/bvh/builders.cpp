#include "accel/bvh/builders.h"

#include "accel/bvh/hlbvh.h"

namespace rayshoot::inline RAYSHOOT_ISA {

TreeBuild chosen_build(const Options& options) {
    return options.choice<TreeBuild>("build",
                                     {{"fast", TreeBuild::fast}, {"default", TreeBuild::standard}});
}

BinaryTree build_tree(std::span<const Box> boxes, const TreeSettings& settings) {
    if (settings.build == TreeBuild::fast) return build_hlbvh(boxes, settings.sah);
    return build_binned_sah(boxes, settings.sah);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
