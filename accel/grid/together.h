#pragma once

#include "accel/grid/grid.h"

/// Coherent rays sweep through the grid as one packet; of each cell that is not empty it is asked
/// which rays enter it.
namespace rayshoot::inline RAYSHOOT_ISA {

/// None where the rays make no packet that could sweep.
inline std::optional<Sweep> Grid::sweep_of(std::span<const Ray> rays, Packet& packet) const {
    if (!packet.load(rays, leaves_.packed().precision(), most_apart_)) return std::nullopt;
    const Beam beam = packet.beam(packet.all());
    Ray farthest = rays.front();
    for (int axis = 0; axis < 3; ++axis) {
        const float lo = beam.origin_lo[axis], hi = beam.origin_hi[axis];
        const float middle = space_.centre()[axis];
        farthest.origin[axis] = std::abs(lo - middle) > std::abs(hi - middle) ? lo : hi;
    }
    if (!(beam.t_min >= 0) || !membership_.made_for(farthest)) return std::nullopt;
    return Sweep::of(packet, beam, grids_.front().lattice);
}

template <Query Q, Counter C>
void Grid::trace_together(Sweep sweep, const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                          C& count) const {
    const Packet& packet = scratch.packet;
    const Lattice& lattice = grids_.front().lattice;
    while (sweep.inside()) {
        const int skipped = visit_slice<Q>(sweep, scratch, count);
        if (skipped == 0 &&
            !packet.any_reaches(static_cast<std::size_t>(sweep.axis()), sweep.end_plane(lattice)))
            break;
        sweep.advance(1 + skipped);
    }
    for (std::size_t i = 0; i < part.rays.size(); ++i) answers.store(part.first + i, packet.hit(i));
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

template <Query Q, Counter C>
inline void Grid::visit_cell(CellWord word, const Box& box, RaySet rays, Scratch& scratch,
                             C& count) const {
    if (word.is_leaf()) [[likely]]
        return visit_leaf<Q>(leaves_.packed(), scratch.packet, rays, PackedLeaf::from(word.leaf()),
                             count);
    visit_grid<Q>(word, box, rays, scratch, count);
}

/// Rays go through a grid in a cell one by one.
template <Query Q, Counter C>
void Grid::visit_grid(CellWord word, const Box& box, RaySet rays, Scratch& scratch,
                      C& count) const {
    scratch.packet.test_each<Q>(rays, [&](const TestRay& ray, Hit& hit) {
        Search<C> search = search_for(ray, hit, scratch, count);
        const Interval inside = clip(ray, box, {ray.t_min, hit.t});
        enter<Q>(grids_[word.grid()], inside.entry, search);
    });
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
