#include "accel/bsp/midpoint.h"

#include <numeric>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

class Builder {
public:
    Builder(const Membership& membership, const Midpoint& settings)
        : membership_(membership), settings_(settings) {}

    BspSketch build(std::span<const std::uint32_t> all) && {
        subdivide(0, {membership_.space(), all, 0, settings_.most_references});
        return std::move(sketch_);
    }

private:
    struct Cell {
        Box box;
        std::span<const std::uint32_t> members;
        int depth;
        std::uint64_t most_references;  ///< of all its leaves
    };

    void subdivide(std::uint32_t node, const Cell& cell) {
        sketch_.depth = std::max(sketch_.depth, cell.depth);
        const int axis = axis_of(cell);
        if (cell.members.size() <= settings_.largest_leaf || cell.depth == settings_.deepest ||
            axis < 0)
            return sketch_.make_leaf(node, cell.members);
        const float plane = cell.box.centre()[axis];
        Box left = cell.box, right = cell.box;
        left.hi[axis] = right.lo[axis] = plane;
        const std::vector<std::uint32_t> in_left = members_in(left, cell.members),
                                         in_right = members_in(right, cell.members);
        const std::uint64_t references = in_left.size() + in_right.size();
        if (references > cell.most_references) {
            sketch_.bounded = true;
            return sketch_.make_leaf(node, cell.members);
        }
        const std::uint64_t spare = cell.most_references - references, share = spare / 2;
        const std::uint32_t child = sketch_.divide(node, axis, plane);
        subdivide(child, {left, in_left, cell.depth + 1, in_left.size() + share});
        subdivide(child + 1, {right, in_right, cell.depth + 1, in_right.size() + spare - share});
    }

    /// The next one in turn that can be halved; -1: none.
    static int axis_of(const Cell& cell) {
        const vec3 centre = cell.box.centre();
        for (int i = 0; i < 3; ++i) {
            const int axis = (cell.depth + i) % 3;
            if (cell.box.lo[axis] < centre[axis] && centre[axis] < cell.box.hi[axis]) return axis;
        }
        return -1;
    }

    std::vector<std::uint32_t> members_in(const Box& box,
                                          std::span<const std::uint32_t> among) const {
        std::vector<std::uint32_t> members;
        for (const std::uint32_t primitive : among)
            if (membership_.in_cell(primitive, box)) members.push_back(primitive);
        return members;
    }

    const Membership& membership_;
    Midpoint settings_;
    BspSketch sketch_;
};

}  // namespace

BspSketch build_midpoint(const Geometry& geometry, const Membership& membership,
                         const Midpoint& settings) {
    std::vector<std::uint32_t> all(geometry.size());
    std::iota(all.begin(), all.end(), 0u);
    return Builder(membership, settings).build(all);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
