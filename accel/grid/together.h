#pragma once

#include "accel/grid/grid.h"

/// Coherent rays sweep through the grid as one packet; of each cell that is not empty it is asked
/// which rays enter it.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Counter C>
bool Grid::trace_together(const Part& part, Answers<Q>& answers, Scratch& scratch, C& count) const {
    Packet& packet = scratch.packet;
    if (!packet.load(part.rays, leaves_.packed().precision(), most_apart_)) return false;
    const Beam beam = packet.beam(packet.all());
    Ray farthest = part.rays.front();
    for (int axis = 0; axis < 3; ++axis) {
        const float lo = beam.origin_lo[axis], hi = beam.origin_hi[axis];
        const float middle = space_.centre()[axis];
        farthest.origin[axis] = std::abs(lo - middle) > std::abs(hi - middle) ? lo : hi;
    }
    if (!(beam.t_min >= 0) || membership_.extra(farthest) > 0) return false;
    const Lattice& lattice = grids_.front().lattice;
    std::optional<Sweep> sweep = Sweep::of(packet, beam, lattice);
    if (!sweep) return false;
    while (sweep->inside()) {
        const int skipped = visit_slice<Q>(*sweep, scratch, count);
        if (skipped == 0 &&
            !packet.any_reaches(static_cast<std::size_t>(sweep->axis()), sweep->end_plane(lattice)))
            break;
        sweep->advance(1 + skipped);
    }
    for (std::size_t i = 0; i < part.rays.size(); ++i) answers.store(part.first + i, packet.hit(i));
    return true;
}

/// Returns how many slices after this one are empty where the rays come through.
template <Query Q, Counter C>
inline int Grid::visit_slice(const Sweep& sweep, Scratch& scratch, C& count) const {
    const Lattice& lattice = grids_.front().lattice;
    const std::optional<CellRange> range = sweep.cells();
    if (!range) return 0;
    int clearance = CellWord::most_clearance;
    for_each_cell(*range, [&](const Cell& cell) {
        const CellWord word = cells_[lattice.number(cell)];
        count(Event::step);
        if (word.is_empty()) {
            count(Event::cell);
            count(Event::empty_cell);
            clearance = std::min(clearance, word.clearance());
            return;
        }
        clearance = 0;
        Boxes<1> box;
        box.set(0, lattice.box(cell));
        RaySet rays = 0;
        for (std::size_t group = 0; group < scratch.packet.groups(); ++group) {
            if constexpr (C::counts) count(Event::bounding_volume_test, Packet::group);
            rays |= scratch.packet.enter(group, box, 0) << group * Packet::group;
        }
        if (rays != 0) visit_cell<Q>(word, lattice.box(cell), rays, scratch, count);
    });
    return sweep.slices_within(clearance);
}

/// What is called most: all that it calls is inlined.
template <Query Q, Counter C>
[[gnu::flatten]] inline void Grid::visit_cell(CellWord word, const Box& box, RaySet rays,
                                              Scratch& scratch, C& count) const {
    const PackedLeaves& leaves = leaves_.packed();
    const PackedLeaf leaf = PackedLeaf::from(word.leaf());
    if (!word.is_leaf() || !leaf.only_triangles() || leaves.precision() != Precision::standard)
        return visit_others<Q>(word, box, rays, scratch, count);
    if constexpr (C::counts) count(Event::cell, static_cast<std::uint64_t>(std::popcount(rays)));
    for (std::uint32_t i = 0; i < leaf.block_count(); ++i)
        scratch.packet.test<Q, Precision::standard>(
            rays, leaves.block<TriangleBlock>(leaf.first_block() + i), leaves.padding(), count);
}

/// Whatever is not triangles in the standard precision; out of the way of those that are.
template <Query Q, Counter C>
void Grid::visit_others(CellWord word, const Box& box, RaySet rays, Scratch& scratch,
                        C& count) const {
    const PackedLeaves& leaves = leaves_.packed();
    const PackedLeaf leaf = PackedLeaf::from(word.leaf());
    Packet& packet = scratch.packet;
    if (!word.is_leaf())
        return packet.test_each<Q>(rays, [&](const TestRay& ray, Hit& hit) {
            Search<C> search = search_for(ray, 0, hit, scratch, count);
            const Interval inside = clip(ray, box, {ray.t_min, hit.t});
            enter<Q>(grids_[word.grid()], inside.entry, search);
        });
    if constexpr (C::counts) count(Event::cell, static_cast<std::uint64_t>(std::popcount(rays)));
    if (leaf.is_mixed())
        return packet.test_each<Q>(rays, [&](const TestRay& ray, Hit& hit) {
            leaves.template test<Q>(leaf, ray, hit, count);
        });
    for (std::uint32_t i = 0; i < leaf.block_count(); ++i) {
        const std::uint32_t block = leaf.first_block() + i;
        if (leaf.only_triangles())
            packet.test<Q, Precision::watertight>(rays, leaves.block<TriangleBlock>(block),
                                                  leaves.padding(), count);
        else packet.test<Q>(rays, leaves.block<SphereBlock>(block), leaves.padding(), count);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
