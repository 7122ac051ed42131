#include "accel/octree/cell.h"
#include "accel/octree/planes.h"

#include <tbb/parallel_for.h>

#include <atomic>
#include <numeric>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

constexpr std::size_t worth_a_task = 512;  ///< members

/// Tests of a leaf, in blocks as wide as those of triangles are.
double blocks(std::size_t members) { return static_cast<double>((members + 3) / 4); }
/// What the step from a cell to its children costs, in tests of a block.
constexpr double step_cost = 1;

class Growing {
public:
    Growing(const Membership& membership, const OctreeSettings& settings)
        : membership_(membership), settings_(settings), lattice_(membership.space()) {}

    /// `most`: references that the leaves below may have, all together.
    void grow(OctreeCell& cell, double most) {
        const std::size_t count = cell.members.size();
        if (count <= settings_.largest_leaf || cell.lattice.level == settings_.depth) return;
        cell.planes = settings_.planes == OctreePlanes::sah ? sah_planes(cell, membership_)
                                                            : middles(cell.lattice);
        auto children = settings_.loose ? deal_out(cell) : cut(cell);
        if (settings_.loose && !is_parted(cell, *children)) return grow(cell, most);
        const double total = references(*children);
        if (total > most) {
            ++held_back_;
            return;
        }
        if (settings_.stop == OctreeStop::cost && !is_worth_it(cell, *children)) return;
        cell.members = {};
        cell.children = std::move(children);
        // Each child's share of what is left: no sum of theirs can exceed it.
        const auto grow_below = [&](std::size_t i) {
            OctreeCell& child = (*cell.children)[i];
            grow(child, most * static_cast<double>(child.members.size()) / total);
        };
        if (count >= worth_a_task) tbb::parallel_for(std::size_t{0}, std::size_t{8}, grow_below);
        else
            for (std::size_t i = 0; i < 8; ++i) grow_below(i);
    }
    std::uint64_t held_back() const { return held_back_; }

private:
    static double references(const std::array<OctreeCell, 8>& children) {
        double total = 0;
        for (const OctreeCell& child : children) total += static_cast<double>(child.members.size());
        return total;
    }

    std::array<float, 3> middles(const OctreePlace& cell) const {
        return {lattice_.middle(0, cell), lattice_.middle(1, cell), lattice_.middle(2, cell)};
    }

    static std::unique_ptr<std::array<OctreeCell, 8>> children_of(const OctreeCell& cell) {
        auto children = std::make_unique<std::array<OctreeCell, 8>>();
        for (unsigned i = 0; i < 8; ++i) {
            OctreeCell& child = (*children)[i];
            child.box = cell.box;
            child.lattice = cell.lattice.child(i);
            for (int axis = 0; axis < 3; ++axis) {
                const float plane = cell.planes[static_cast<std::size_t>(axis)];
                (i >> axis & 1 ? child.box.lo : child.box.hi)[axis] = plane;
            }
        }
        return children;
    }

    std::unique_ptr<std::array<OctreeCell, 8>> cut(const OctreeCell& cell) const {
        auto children = children_of(cell);
        for (OctreeCell& child : *children) {
            for (const std::uint32_t primitive : cell.members)
                if (membership_.in_cell(primitive, child.box)) child.members.push_back(primitive);
        }
        return children;
    }

    std::unique_ptr<std::array<OctreeCell, 8>> deal_out(const OctreeCell& cell) const {
        auto children = children_of(cell);
        for (const std::uint32_t primitive : cell.members) {
            const vec3 centre = membership_.box(primitive).centre();
            std::size_t child = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                child |= std::size_t{centre[static_cast<int>(axis)] >= cell.planes[axis]} << axis;
            (*children)[child].members.push_back(primitive);
        }
        return children;
    }

    /// False, and the cell is that child, where one child has all members.
    static bool is_parted(OctreeCell& cell, const std::array<OctreeCell, 8>& children) {
        for (const OctreeCell& child : children) {
            if (child.members.size() != cell.members.size()) continue;
            cell.box = child.box;
            cell.lattice = child.lattice;
            return false;
        }
        return true;
    }

    /// What a ray has to meet so that a cell is visited.
    double area(const OctreeCell& cell) const {
        if (!settings_.loose) return cell.box.half_area();
        Box contents;
        for (const std::uint32_t primitive : cell.members)
            contents.include(membership_.box(primitive));
        return cell.members.empty() ? 0 : contents.half_area();
    }

    /// MacDonald & Booth 1990: a ray that meets the cell meets a child as often as their areas say.
    bool is_worth_it(const OctreeCell& cell, const std::array<OctreeCell, 8>& children) const {
        double cost = 0;
        for (const OctreeCell& child : children) cost += area(child) * blocks(child.members.size());
        const double whole = area(cell);
        return cost + step_cost * whole < blocks(cell.members.size()) * whole;
    }

    const Membership& membership_;
    const OctreeSettings settings_;
    const OctreeLattice lattice_;
    std::atomic<std::uint64_t> held_back_ = 0;
};

}  // namespace

OctreeGrowth grow_octree(std::uint32_t primitives, const Membership& membership,
                         const OctreeSettings& settings) {
    OctreeGrowth growth;
    growth.root.box = membership.space();
    growth.root.members.resize(primitives);
    std::iota(growth.root.members.begin(), growth.root.members.end(), 0u);
    Growing growing(membership, settings);
    growing.grow(growth.root, settings.most_references * primitives);
    growth.held_back = growing.held_back();
    return growth;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
