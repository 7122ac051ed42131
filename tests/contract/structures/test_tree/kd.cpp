#include "tests/contract/structures/test_tree/kd.h"

#include <numeric>

namespace rayshoot::contract {
namespace {

constexpr std::size_t small_enough = 3;  // primitives
constexpr int deep_enough = 14;          // levels

int longest_side(const Box& box) {
    const vec3 size = box.size();
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Closed on both sides: what touches the plane is in both.
std::array<bool, 2> sides(const Box& bounds, int axis, float plane, KdTree::Straddlers straddlers) {
    if (straddlers == KdTree::Straddlers::in_both)
        return {bounds.lo[axis] <= plane, bounds.hi[axis] >= plane};
    const bool low = bounds.centre()[axis] <= plane;
    return {low, !low};
}

}  // namespace

KdTree::KdTree(const Geometry& geometry) : nodes_(1) {
    nodes_[0].cell = geometry.bounds();
    nodes_[0].primitives.resize(geometry.size());
    std::iota(nodes_[0].primitives.begin(), nodes_[0].primitives.end(), 0u);
}

bool KdTree::split(const Geometry& geometry, std::uint32_t node, Straddlers straddlers) {
    const Node parent = nodes_[node];
    if (parent.primitives.size() <= small_enough || parent.depth >= deep_enough) return false;
    const int axis = longest_side(parent.cell);
    const float plane = parent.cell.centre()[axis];
    std::array<Node, 2> children;
    for (Node& child : children) {
        child.cell = parent.cell;
        child.depth = parent.depth + 1;
    }
    children[0].cell.hi[axis] = children[1].cell.lo[axis] = plane;
    for (const std::uint32_t primitive : parent.primitives) {
        const auto in = sides(geometry.bounds(primitive), axis, plane, straddlers);
        for (const std::size_t side : {0u, 1u})
            if (in[side]) children[side].primitives.push_back(primitive);
    }
    for (const Node& child : children)
        if (child.primitives.size() == parent.primitives.size() && parent.depth > 6) return false;
    nodes_[node].axis = axis;
    nodes_[node].plane = plane;
    nodes_[node].low = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].primitives.clear();
    for (Node& child : children) nodes_.push_back(std::move(child));
    return true;
}

void KdTree::split_all(const Geometry& geometry, Straddlers straddlers) {
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) split(geometry, node, straddlers);
}

std::size_t KdTree::bytes() const {
    std::size_t total = nodes_.size() * sizeof(Node);
    for (const Node& node : nodes_) total += node.primitives.size() * sizeof(std::uint32_t);
    return total;
}

}  // namespace rayshoot::contract
