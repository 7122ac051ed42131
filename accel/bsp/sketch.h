#pragma once

#include "accel/bsp/plane.h"
#include "accel/core/geometry.h"

#include <bit>
#include <memory>
#include <vector>

/// What builders make: a tree that has not been laid out yet.
namespace rayshoot::inline RAYSHOOT_ISA {

inline constexpr int deepest_bsp = 60;  ///< levels; builders keep to it, stacks rely on it

/// Instead of an axis: the plane lies anyhow, and `plane` has the bits of its number.
inline constexpr std::uint8_t oblique_axis = 3;

/// A tree, or the top of one whose other parts were built each by itself.
struct BspSketch {
    enum class Kind : std::uint8_t { interior, leaf, part };
    struct Node {
        float plane = 0;
        std::uint32_t first = 0;  ///< left child, the right one follows; first member; or the part
        std::uint32_t count = 0;  ///< of a leaf's members
        Kind kind = Kind::leaf;
        std::uint8_t axis = 0;
    };

    std::vector<Node> nodes = std::vector<Node>(1);  ///< the first one is the root
    std::vector<std::uint32_t> members;              ///< primitive numbers
    std::vector<ObliquePlane> planes;                ///< those of nodes that no axis is across
    std::vector<std::unique_ptr<BspSketch>> parts;
    int depth = 0;         ///< of the deepest leaf
    bool bounded = false;  ///< a node was not divided because of the bound on references

    /// Returns the number of the left child.
    std::uint32_t divide(std::uint32_t node, int axis, float plane) {
        const auto children = static_cast<std::uint32_t>(nodes.size());
        nodes[node] = {plane, children, 0, Kind::interior, static_cast<std::uint8_t>(axis)};
        nodes.resize(nodes.size() + 2);
        return children;
    }
    std::uint32_t divide(std::uint32_t node, const ObliquePlane& plane) {
        planes.push_back(plane);
        return divide(node, oblique_axis,
                      std::bit_cast<float>(static_cast<std::uint32_t>(planes.size() - 1)));
    }
    void make_leaf(std::uint32_t node, std::span<const std::uint32_t> primitives) {
        nodes[node] = {0, static_cast<std::uint32_t>(members.size()),
                       static_cast<std::uint32_t>(primitives.size()), Kind::leaf, 0};
        members.insert(members.end(), primitives.begin(), primitives.end());
    }
    void make_part(std::uint32_t node, std::unique_ptr<BspSketch> part) {
        nodes[node] = {0, static_cast<std::uint32_t>(parts.size()), 0, Kind::part, 0};
        parts.push_back(std::move(part));
    }
    /// 1: the node is a leaf without members.
    std::uint32_t empty(std::uint32_t node) const {
        return nodes[node].kind == Kind::leaf && nodes[node].count == 0;
    }
    std::span<const std::uint32_t> members_of(const Node& leaf) const {
        return std::span(members).subspan(leaf.first, leaf.count);
    }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA
