#include "accel/bsp/general/general_bsp.h"

#include "accel/bsp/general/sub_tree.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

BspSketch sketched(const Geometry& geometry, const Membership& membership, const Options& chosen) {
    const int depth = chosen.integer("depth", 0, deepest_bsp);
    KdSettings settings;
    settings.deepest = depth == 0 ? auto_depth(geometry.size()) : depth;
    settings.smallest_divided = static_cast<std::uint32_t>(chosen.integer("leaf", 0, 64));
    settings.most_references = most_references(geometry.size());
    const int few = chosen.integer("general", 0, GeneralSubTree::most_references);
    return build_general(geometry, membership, settings, static_cast<std::size_t>(few));
}

}  // namespace

GeneralBsp::GeneralBsp(const BuildInput& input, const Options& chosen)
    : membership_(input, Overlap::exact) {
    const BspSketch sketch = sketched(input.geometry, membership_, chosen);
    tree_ = laid_out(input.geometry, sketch);
    if (membership_.overlap() != Overlap::exact) return;
    frame_ = ObliqueFrame(input.geometry, membership_);
    outlines_ = outlined(input.geometry, sketch, tree_);
    *tree_.footprint.bytes += outlines_.bytes();
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
