#include "accel/bsp/outlines.h"

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

class Maker {
public:
    Maker(const Geometry& geometry, const BspTree& tree, Outlines& outlines)
        : geometry_(geometry), tree_(tree), outlines_(outlines) {}

    struct SubTree {
        Outlines::Outline outline;
        std::uint64_t references = 0;
    };

    /// Node `from` of the sketch has been laid out as node `to`.
    SubTree outline(const BspSketch& sketch, std::uint32_t from, std::uint32_t to) {
        const BspSketch::Node& node = sketch.nodes[from];
        if (node.kind == BspSketch::Kind::part) return outline(*sketch.parts[node.first], 0, to);
        if (node.kind == BspSketch::Kind::leaf) {
            SubTree leaf{{{}, to}, node.count};
            for (const std::uint32_t primitive : sketch.members_of(node))
                leaf.outline.box.include(geometry_.bounds(primitive));
            return leaf;
        }
        const std::uint32_t children = tree_.nodes[to].children();
        const SubTree left = outline(sketch, node.first, children);
        const SubTree right = outline(sketch, node.first + 1, children + 1);
        SubTree both{{left.outline.box, to}, left.references + right.references};
        both.outline.box.include(right.outline.box);
        if (both.references > Outlines::references_per_box)
            both.outline = outlines_.join(left.outline, right.outline);
        return both;
    }

private:
    const Geometry& geometry_;
    const BspTree& tree_;
    Outlines& outlines_;
};

}  // namespace

Outlines outlined(const Geometry& geometry, const BspSketch& sketch, const BspTree& tree) {
    Outlines outlines;
    outlines.set_root(Maker(geometry, tree, outlines).outline(sketch, 0, 0).outline);
    return outlines;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
