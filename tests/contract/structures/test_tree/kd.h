#pragma once

#include "accel/core/geometry.h"

/// A small kd-tree: cells halved at the middle of their longest side, primitives filed by their
/// bounds in every cell that these touch. A reference for tests, not for speed.
namespace rayshoot::contract {

class KdTree {
public:
    struct Node {
        Box cell;
        int depth = 0;
        int axis = -1;  ///< -1: a leaf
        float plane = 0;
        std::uint32_t low = 0;  ///< the child below the plane; the one above is the next
        std::vector<std::uint32_t> primitives;  ///< ascending; of a leaf

        bool leaf() const { return axis < 0; }
    };
    /// Where a primitive is filed whose bounds touch both sides.
    enum class Straddlers { in_both, with_their_centre };

    KdTree() = default;
    /// One leaf with everything.
    explicit KdTree(const Geometry& geometry);

    /// Splits a leaf in two, unless it is small or deep enough, or nothing would be gained.
    bool split(const Geometry& geometry, std::uint32_t node, Straddlers straddlers);
    /// Splits until nothing is left to split.
    void split_all(const Geometry& geometry, Straddlers straddlers);

    const Node& node(std::uint32_t number) const { return nodes_[number]; }
    std::span<const Node> nodes() const { return nodes_; }
    bool empty() const { return nodes_.empty(); }
    std::size_t bytes() const;

private:
    std::vector<Node> nodes_;
};

}  // namespace rayshoot::contract
