#include "accel/bsp/outlines.h"

namespace rayshoot::inline RAYSHOOT_ISA {

class Outlines::Maker {
public:
    Maker(const Geometry& geometry, const BspTree& tree, std::vector<Pair>& pairs)
        : geometry_(geometry), tree_(tree), pairs_(pairs) {}

    struct Outline {
        Child child;
        std::uint64_t references = 0;
    };

    /// Node `from` of the sketch has been laid out as node `to`.
    Outline outline(const BspSketch& sketch, std::uint32_t from, std::uint32_t to) {
        const BspSketch::Node& node = sketch.nodes[from];
        if (node.kind == BspSketch::Kind::part) return outline(*sketch.parts[node.first], 0, to);
        if (node.kind == BspSketch::Kind::leaf) {
            Outline leaf{{{}, to}, node.count};
            for (const std::uint32_t primitive : sketch.members_of(node))
                leaf.child.box.include(geometry_.bounds(primitive));
            return leaf;
        }
        const std::uint32_t children = tree_.nodes[to].children();
        const Outline left = outline(sketch, node.first, children);
        const Outline right = outline(sketch, node.first + 1, children + 1);
        Outline both{{left.child.box, to}, left.references + right.references};
        both.child.box.include(right.child.box);
        if (both.references > references_per_box) {
            both.child.place = pair_bit | static_cast<std::uint32_t>(pairs_.size());
            pairs_.push_back({left.child, right.child});
        }
        return both;
    }

private:
    const Geometry& geometry_;
    const BspTree& tree_;
    std::vector<Pair>& pairs_;
};

Outlines::Outlines(const Geometry& geometry, const BspSketch& sketch, const BspTree& tree) {
    root_ = Maker(geometry, tree, pairs_).outline(sketch, 0, 0).child;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
