#include "accel/bvh8/layout.h"

#include "accel/bvh8/collapse.h"
#include "accel/simd/leaf_packer.h"

#include <tbb/parallel_for.h>

#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Sub-trees that are laid out each by itself; enough of them that no thread waits long.
constexpr std::size_t enough_parts = 256;

std::uint32_t blocks_of(const BinaryTree::Node& leaf) {
    constexpr auto width = static_cast<std::uint32_t>(TriangleBlock::width);
    return (leaf.count + width - 1) / width;
}

/// A wide node before it has a place.
struct Sketch {
    Children children;
    std::uint32_t first_child = 0;  ///< number of the first one that is no leaf; the others follow
    std::uint32_t first_block = 0;  ///< of the leaves, likewise

    Sketch(const BinaryTree& tree, std::uint32_t node, std::size_t width)
        : children(Collapse(tree, node, width).children()) {}
};

/// Wide nodes that are numbered by themselves, from 0, and the blocks of their leaves.
struct Part {
    std::vector<Sketch> nodes;
    std::uint32_t blocks = 0;
    std::uint32_t first_node = 0, first_block = 0;  ///< in the whole

    /// Takes the children of one more node into account; calls `descend` with those to follow.
    template <class Descend>
    void expand(const BinaryTree& tree, Sketch& sketch, std::uint32_t next_number,
                const Descend& descend) {
        sketch.first_child = next_number;
        sketch.first_block = blocks;
        for (const std::uint32_t number : sketch.children) {
            const BinaryTree::Node& child = tree.nodes[number];
            if (child.count > 0) blocks += blocks_of(child);
            else descend(number);
        }
    }
};

template <class Node>
class Layout {
public:
    Layout(const Geometry& geometry, const BinaryTree& tree) : tree_(tree), packer_(geometry) {
        sketch_top();
        tbb::parallel_for(std::size_t{1}, parts_.size(), [&](std::size_t i) { sketch(parts_[i]); });
        const Part end = place_parts();
        nodes_ = RawArray<Node>(end.first_node);
        parallel_ = packer_.make_room_for_triangles(end.first_block);
    }

    WideTree<Node> build() && {
        if (parallel_) {
            tbb::parallel_for(std::size_t{0}, parts_.size(),
                              [&](std::size_t i) { fill(parts_[i]); });
        } else {
            for (const Part& part : parts_) fill(part);
        }
        return {std::move(nodes_), std::move(packer_).build(), tree_.leaves, tree_.depth};
    }

private:
    /// Breadth first, until the nodes that wait to be expanded are enough to be a part each.
    void sketch_top() {
        Part top;
        std::vector<std::uint32_t> waiting{BinaryTree::root};
        std::size_t next = 0;
        for (; next < waiting.size() && waiting.size() - next < enough_parts; ++next) {
            Sketch& sketch = top.nodes.emplace_back(tree_, waiting[next], Node::width);
            top.expand(tree_, sketch, static_cast<std::uint32_t>(waiting.size()),
                       [&](std::uint32_t child) { waiting.push_back(child); });
        }
        parts_.resize(1 + waiting.size() - next);
        for (std::size_t i = 1; i < parts_.size(); ++i)
            parts_[i].nodes.emplace_back(tree_, waiting[next + i - 1], Node::width);
        parts_.front() = std::move(top);
    }

    /// Depth first.
    void sketch(Part& part) {
        std::vector<std::uint32_t> pending{0};
        while (!pending.empty()) {
            const std::uint32_t number = pending.back();
            pending.pop_back();
            Sketch here = part.nodes[number];
            part.expand(tree_, here, static_cast<std::uint32_t>(part.nodes.size()),
                        [&](std::uint32_t child) {
                            pending.push_back(static_cast<std::uint32_t>(part.nodes.size()));
                            part.nodes.emplace_back(tree_, child, Node::width);
                        });
            part.nodes[number] = here;
        }
    }

    /// One after the other. Returns where one more would stand.
    Part place_parts() {
        Part end;
        for (Part& part : parts_) {
            part.first_node = end.first_node;
            part.first_block = end.first_block;
            end.first_node += static_cast<std::uint32_t>(part.nodes.size());
            end.first_block += part.blocks;
        }
        return end;
    }

    /// In the top, numbers beyond its own are those of the other parts.
    std::uint32_t number_of(const Part& part, std::uint32_t node) const {
        if (&part != &parts_.front() || node < part.nodes.size()) return part.first_node + node;
        return parts_[1 + node - part.nodes.size()].first_node;
    }

    void fill(const Part& part) {
        for (std::size_t i = 0; i < part.nodes.size(); ++i)
            new (&nodes_[part.first_node + i]) Node(siblings(part, part.nodes[i]));
    }

    Siblings siblings(const Part& part, const Sketch& sketch) {
        Siblings all;
        std::uint32_t next_child = sketch.first_child;
        std::uint32_t next_block = part.first_block + sketch.first_block;
        for (const std::uint32_t number : sketch.children) {
            const BinaryTree::Node& child = tree_.nodes[number];
            if (child.count > 0) {
                all.add(child.bounds, WideChild::leaf(packed(child, next_block)));
                next_block += blocks_of(child);
            } else {
                all.add(child.bounds, WideChild::node(number_of(part, next_child++)));
            }
        }
        return all;
    }

    PackedLeaf packed(const BinaryTree::Node& leaf, std::uint32_t first_block) {
        const auto members = std::span(tree_.order).subspan(leaf.first, leaf.count);
        return parallel_ ? packer_.set_triangles(first_block, members) : packer_.add(members);
    }

    const BinaryTree& tree_;
    LeafPacker packer_;
    std::vector<Part> parts_;  ///< the first one is the top, without which there are no others
    RawArray<Node> nodes_;
    bool parallel_ = false;
};

}  // namespace

template <class Node>
WideTree<Node> laid_out(const Geometry& geometry, const BinaryTree& tree) {
    if (!tree.nodes.empty()) return Layout<Node>(geometry, tree).build();
    WideTree<Node> nothing{RawArray<Node>(1), LeafPacker(geometry).build(), 0, 0};
    new (nothing.nodes.data()) Node();
    return nothing;
}

template WideTree<WideNode8> laid_out(const Geometry& geometry, const BinaryTree& tree);
template WideTree<WideNode4> laid_out(const Geometry& geometry, const BinaryTree& tree);
template WideTree<WideNode8q> laid_out(const Geometry& geometry, const BinaryTree& tree);

}  // namespace rayshoot::inline RAYSHOOT_ISA
