#include "accel/bvh8/layout.h"

#include "accel/simd/leaf_packer.h"

#include <tbb/parallel_for.h>

#include <bit>
#include <vector>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

/// Sub-trees that are laid out each by itself; enough of them that no thread waits long.
constexpr std::size_t enough_parts = 256;

std::uint32_t blocks_of(const BinaryTree::Node& leaf) {
    constexpr auto width = static_cast<std::uint32_t>(TriangleBlock::width);
    return (leaf.count + width - 1) / width;
}

/// The binary nodes that become the children of one wide node: the one with the largest box is
/// replaced by its two children until there are enough (Wald, Benthin & Boulos 2008).
class Children {
public:
    Children(const BinaryTree& tree, std::uint32_t node, std::size_t enough) {
        areas_.fill(leaf);
        set(0, tree, node);
        while (size_ < enough && open_largest(tree)) {
        }
    }
    std::uint32_t size() const { return size_; }
    std::uint32_t operator[](std::uint32_t i) const { return nodes_[i]; }

private:
    void set(std::uint32_t i, const BinaryTree& tree, std::uint32_t number) {
        const BinaryTree::Node& node = tree.nodes[number];
        nodes_[i] = number;
        if (node.count == 0) __builtin_prefetch(&tree.nodes[node.first]);
        const float area = node.bounds.half_area();
        areas_[i] = node.count > 0 ? leaf : area >= 0 ? area : 0;  // NaN: flat, and unbounded
    }
    bool open_largest(const BinaryTree& tree) {
        using namespace simd;
        constexpr auto tag = floats<most_children>;
        const auto areas = hn::Load(tag, areas_.data());
        const auto largest_area = hn::MaxOfLanes(tag, areas);
        const auto largest =
            static_cast<std::uint32_t>(std::countr_zero(bits(tag, hn::Eq(areas, largest_area))));
        if (areas_[largest] == leaf) return false;
        const std::uint32_t left = tree.nodes[nodes_[largest]].first;
        set(largest, tree, left);
        set(size_++, tree, left + 1);
        return true;
    }

    static constexpr float leaf = -1;  ///< less than any area
    std::array<std::uint32_t, most_children> nodes_;
    alignas(32) std::array<float, most_children> areas_;
    std::uint32_t size_ = 1;
};

/// A wide node before it has a place.
struct Sketch {
    Children children;
    std::uint32_t first_child = 0;  ///< number of the first one that is no leaf; the others follow
    std::uint32_t first_block = 0;  ///< of the leaves, likewise

    Sketch(const BinaryTree& tree, std::uint32_t node, std::size_t width)
        : children(tree, node, width) {}
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
        for (std::uint32_t i = 0; i < sketch.children.size(); ++i) {
            const BinaryTree::Node& child = tree.nodes[sketch.children[i]];
            if (child.count > 0) blocks += blocks_of(child);
            else descend(sketch.children[i]);
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
        return {std::move(nodes_), std::move(packer_).build()};
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
            fill(part, part.nodes[i], *new (&nodes_[part.first_node + i]) Node());
    }

    void fill(const Part& part, const Sketch& sketch, Node& node) {
        std::uint32_t next_child = sketch.first_child;
        std::uint32_t next_block = part.first_block + sketch.first_block;
        Boxes<Node::width> exact;
        for (std::uint32_t i = 0; i < sketch.children.size(); ++i) {
            const BinaryTree::Node& child = tree_.nodes[sketch.children[i]];
            exact.set(i, child.bounds);
            if (child.count > 0) {
                node.children[i] = WideChild::leaf(packed(child, next_block)).bits();
                next_block += blocks_of(child);
            } else {
                node.children[i] = WideChild::node(number_of(part, next_child++)).bits();
            }
        }
        node.bounds = decltype(node.bounds)(exact);
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
    WideTree<Node> nothing{RawArray<Node>(1), LeafPacker(geometry).build()};
    new (nothing.nodes.data()) Node();
    return nothing;
}

template WideTree<WideNode8> laid_out(const Geometry& geometry, const BinaryTree& tree);
template WideTree<WideNode4> laid_out(const Geometry& geometry, const BinaryTree& tree);
template WideTree<WideNode8q> laid_out(const Geometry& geometry, const BinaryTree& tree);

}  // namespace rayshoot::inline RAYSHOOT_ISA
