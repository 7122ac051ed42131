#pragma once

#include "accel/bvh/binned_sah.h"
#include "accel/core/options.h"

/// The builders by class: how much time for how good a tree.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class TreeBuild : std::uint8_t { fast, standard, high };

struct TreeSettings {
    TreeBuild build = TreeBuild::standard;
    BinnedSah sah;
};

/// All of them work in parallel, and build the same tree for any number of threads.
BinaryTree build_tree(std::span<const Box> boxes, const TreeSettings& settings);

/// The option `build` of a structure.
inline constexpr OptionInfo build_option{"build", "fast|default|high", "default",
                                         "Morton codes, binned SAH, or the latter reinserted"};
TreeBuild chosen_build(const Options& options);

}  // namespace rayshoot::inline RAYSHOOT_ISA
