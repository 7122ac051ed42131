#include "accel/bsp/general/sub_tree.h"

#include "accel/bsp/kd_builder.h"

#include <algorithm>

namespace rayshoot::inline RAYSHOOT_ISA {
namespace {

void make_leaf(BspSketch& sketch, std::uint32_t node, const auto& members) {
    std::vector<std::uint32_t> numbers;
    for (const auto& member : members) numbers.push_back(member.number);
    std::sort(numbers.begin(), numbers.end());
    sketch.make_leaf(node, numbers);
}

void add(const std::optional<Part>& part, std::vector<Part>& to) {
    if (part) to.push_back(*part);
}

}  // namespace

void GeneralSubTree::build(BspSketch& sketch, std::uint32_t node, const KdCell& cell,
                           std::span<const Reference> references) const {
    sketch.depth = std::max(sketch.depth, cell.depth);
    if (references.size() > most_references) return make_leaf(sketch, node, references);
    Parts parts;
    for (const Reference& reference : references) add(maker_.whole(reference), parts);
    subdivide(sketch, node, cell, Polyhedron(cell.box, maker_.frame().centre), parts);
}

void GeneralSubTree::subdivide(BspSketch& sketch, std::uint32_t node, const KdCell& cell,
                               const Polyhedron& hull, const Parts& parts) const {
    sketch.depth = std::max(sketch.depth, cell.depth);
    const GeneralSplit split = best_general_split(geometry_, parting_, maker_, cell, hull, parts);
    if (split.cost == infinity) return make_leaf(sketch, node, parts);
    const Halves in =
        split.oblique ? halves(split.plane, parts) : halves(split.axial, cell.box, parts);
    const std::size_t left = in.left.size(), right = in.right.size();
    if (left + right > cell.most_references) {
        sketch.bounded = true;
        return make_leaf(sketch, node, parts);
    }
    const ObliquePlane plane =
        split.oblique ? split.plane : maker_.frame().across(split.axial.axis, split.axial.plane);
    const KdCell::Halves cells =
        split.oblique ? cell.halves(left, right) : cell.halves(split.axial, left, right);
    const std::uint32_t children = split.oblique
                                       ? sketch.divide(node, plane)
                                       : sketch.divide(node, split.axial.axis, split.axial.plane);
    subdivide(sketch, children, cells.left, hull.below(plane), in.left);
    subdivide(sketch, children + 1, cells.right, hull.above(plane), in.right);
}

GeneralSubTree::Halves GeneralSubTree::halves(const ObliquePlane& plane, const Parts& parts) const {
    Halves in;
    for (const Part& part : parts) {
        const Heights heights = maker_.heights(part, plane);
        const bool below = maker_.is_below(heights), above = maker_.is_above(heights);
        if (below) add(above ? maker_.below(part, plane) : part, in.left);
        if (above) add(below ? maker_.above(part, plane) : part, in.right);
    }
    return in;
}

GeneralSubTree::Halves GeneralSubTree::halves(const KdSplit& split, const Box& cell,
                                              const Parts& parts) const {
    Halves in;
    Box left_box = cell, right_box = cell;
    left_box.hi[split.axis] = right_box.lo[split.axis] = split.plane;
    for (const Part& part : parts) {
        const bool left = split.in_left(part.reference()), right = split.in_right(part.reference());
        if (left) add(right ? within(part, left_box) : part, in.left);
        if (right) add(left ? within(part, right_box) : part, in.right);
    }
    return in;
}

std::optional<Part> GeneralSubTree::within(const Part& part, const Box& half) const {
    return maker_.within(part, half,
                         part.size > 0 ? half : parting_.clipped(part.reference(), half));
}

BspSketch build_general(const Geometry& geometry, const Membership& membership,
                        const KdSettings& settings, std::size_t few) {
    if (few == 0 || membership.overlap() != Overlap::exact)
        return build_by_bins(geometry, membership, settings);
    const GeneralSubTree general(geometry, membership, settings);
    KdSettings mixed = settings;
    mixed.most_for_other = few;
    mixed.other = [&](BspSketch& sketch, std::uint32_t node, const KdCell& cell,
                      std::span<const Reference> references) {
        general.build(sketch, node, cell, references);
    };
    return build_by_bins(geometry, membership, mixed);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
