#pragma once

#include "accel/core/structure.h"
#include "accel/grid/cell_leaves.h"
#include "accel/grid/flock.h"
#include "accel/grid/layers.h"
#include "accel/grid/sweep.h"
#include "accel/grid/walk.h"
#include "accel/simd/in_packets.h"
#include "accel/simd/packet_leaf.h"
#include "accel/space/outlines.h"

/// Regular grid: space in equal boxes, each with the objects in it, and grids in its cells where
/// they are crowded. See README.md.
namespace rayshoot::inline RAYSHOOT_ISA {

class Grid {
public:
    static constexpr std::string_view name = "grid";
    static constexpr std::string_view summary =
        "regular grid by 3D-DDA: uniform, recursive or two-level, with SIMD cells";
    static constexpr bool complete = true, remembers = false;
    static constexpr std::array options{
        OptionInfo{"resolution", "cleary|woo|klimaszewski|AxBxC", "cleary",
                   "the rule for the numbers of cells, or the numbers"},
        OptionInfo{"density", "auto|0.01 to 64", "auto",
                   "cells per primitive; auto: what should cost a ray least"},
        OptionInfo{"overlap", "bounds|exact|havran", "exact",
                   "which primitives a cell holds: by their boxes, exactly, by Havran's boxes"},
        OptionInfo{"leaves", "packed|single", "packed", "tested by blocks or one by one"},
        OptionInfo{"mailbox", "on|off", "off", "no object twice for a ray; for leaves=single"},
        OptionInfo{"skip", "none|macro|distance", "distance",
                   "how rays get through empty space: macro cells or a distance field"},
        OptionInfo{"nested", "off|recursive|two_level", "off", "grids in crowded cells"},
        OptionInfo{"depth", "2 to 6", "3", "levels of grids with nested=recursive"},
        OptionInfo{"leaf", "1 to 1000", "8", "most primitives in a cell that is not divided"},
        OptionInfo{"top", "0.001 to 64", "0.12",
                   "cells per primitive of the upper grid with nested=two_level"},
        OptionInfo{"abreast", "on|off", "on",
                   "rays side by side, a lane each; for leaves=packed and not skip=macro"},
        OptionInfo{"packets", "on|off", "on",
                   "coherent rays together, slice by slice; for leaves=packed and not skip=macro"},
        OptionInfo{"bound", "1 to 100000", "64", "most references per primitive, by boxes"}};
    // Bounded, so that scenes with everything in every cell do not take minutes.
    static constexpr std::array<std::string_view, 17> configurations{
        "grid",
        "grid:packets=off",
        "grid:abreast=off,packets=off",
        "grid:resolution=woo,density=1,overlap=havran,leaves=single,skip=none",
        "grid:resolution=klimaszewski,density=10,overlap=bounds,skip=macro",
        "grid:resolution=35x35x35,overlap=havran,leaves=single,skip=none",
        "grid:density=1,overlap=bounds,leaves=single,mailbox=on,skip=none",
        "grid:density=8,overlap=exact,leaves=single,mailbox=on",
        "grid:density=0.1,overlap=bounds,skip=none",
        "grid:resolution=1x1x1",
        "grid:density=64,overlap=bounds,bound=2",
        "grid:density=3,overlap=havran,leaves=single,skip=none,nested=recursive,bound=16",
        "grid:density=2,overlap=exact,nested=recursive,leaf=2,skip=macro,bound=8",
        "grid:density=2,overlap=bounds,nested=recursive,leaf=2,depth=2",
        "grid:density=2.4,nested=two_level",
        "grid:density=2.4,overlap=bounds,nested=two_level,top=1,leaf=1,skip=none",
        "grid:density=3,overlap=bounds,nested=recursive,leaf=1,depth=6,bound=3"};

    struct Scratch {
        Mailbox mailbox;
        Flock flock;
        Packet packet;

        std::size_t bytes() const { return sizeof(*this); }
    };

    Grid(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    void many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch, C& count) const;
    Footprint footprint() const { return footprint_; }

private:
    /// A ray on its way, with what it found.
    template <Counter C>
    struct Search {
        const TestRay& ray;
        bool along_planes;
        Hit& hit;
        Scratch& scratch;
        C& count;
    };

    template <Query Q>
    static bool over(const Hit& hit) {
        return Q == Query::occluded && hit.primitive != no_primitive;
    }
    template <Counter C>
    Search<C> search_for(const TestRay& ray, Hit& hit, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    void trace_alone(const Ray& ray, Hit& hit, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    [[gnu::noinline]] void trace_from_afar(Search<C>& search) const;
    template <Query Q, Counter C>
    void trace_each(const BatchPart& part, Answers<Q>& answers, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    struct Abreast;
    std::optional<Sweep> sweep_of(std::span<const Ray> rays, Packet& packet) const;
    template <Query Q, Counter C>
    void trace_together(Sweep sweep, const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                        C& count) const;
    template <Query Q, Counter C>
    int visit_slice(const Sweep& sweep, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    void visit_cell(CellWord word, const Box& box, RaySet rays, Scratch& scratch, C& count) const;
    template <Query Q, Counter C>
    [[gnu::noinline]] void visit_grid(CellWord word, const Box& box, RaySet rays, Scratch& scratch,
                                      C& count) const;
    template <Query Q, Counter C>
    void enter(const SubGrid& grid, float t, Search<C>& search) const;
    template <Query Q, Counter C>
    void walk(const SubGrid& grid, float t, Search<C>& search) const;
    template <Query Q, Counter C>
    [[gnu::noinline]] void walk_layers(const SubGrid& grid, Search<C>& search) const;
    template <Query Q, Counter C>
    CellWord visit(const SubGrid& grid, const Cell& cell, float t, Search<C>& search) const;
    void fetch(CellWord word) const;
    bool runs_in_a_plane(const Lattice& lattice, const SlabRay& ray) const;

    Membership membership_;
    std::vector<SubGrid> grids_;
    PagedVector<CellWord> cells_;
    OutlinedRuns outlines_;  ///< of cells, for the rays that these are not made for
    CellLeaves leaves_;
    Skip skip_ = Skip::none;
    bool abreast_ = false, packets_ = false;
    float most_apart_ = 0;  ///< along an axis, origins of the rays of a packet
    Box space_;             ///< of the outermost grid's cells; empty where there are none
    Box nearby_;            ///< where rays may begin that go abreast
    Footprint footprint_;
};

template <Query Q, Counter C>
inline void Grid::many(const RayBatch& batch, Answers<Q>& answers, Scratch& scratch,
                       C& count) const {
    const auto each = [&](const BatchPart& part) { trace_each<Q>(part, answers, scratch, count); };
    if (!packets_) return each({batch.rays});
    std::optional<Sweep> sweep;
    in_packets(
        batch.rays,
        [&](std::span<const Ray> rays) {
            sweep = sweep_of(rays, scratch.packet);
            return sweep.has_value();
        },
        [&](const BatchPart& part) { trace_together<Q>(*sweep, part, answers, scratch, count); },
        each);
}

template <Query Q, Counter C>
inline void Grid::trace_each(const BatchPart& part, Answers<Q>& answers, Scratch& scratch,
                             C& count) const {
    constexpr std::size_t few = 4;  // for which a flock does not pay
    if (abreast_ && part.rays.size() > few)
        return Abreast<Q, C>{*this, part, answers, scratch, count}.trace();
    for (std::size_t i = 0; i < part.rays.size(); ++i) {
        Hit hit = nothing_yet(part.rays[i]);
        trace_alone<Q>(part.rays[i], hit, scratch, count);
        answers.store(part.first + i, hit);
    }
}

template <Counter C>
inline auto Grid::search_for(const TestRay& ray, Hit& hit, Scratch& scratch, C& count) const
    -> Search<C> {
    const auto unbounded = [&](int axis) { return !(std::abs(ray.inverse[axis]) < infinity); };
    return {ray, unbounded(0) || unbounded(1) || unbounded(2), hit, scratch, count};
}

template <Query Q, Counter C>
inline void Grid::trace_alone(const Ray& incoming, Hit& hit, Scratch& scratch, C& count) const {
    if (grids_.empty()) return;
    const TestRay ray = leaves_.prepared(incoming);
    Search<C> search = search_for(ray, hit, scratch, count);
    if (leaves_.uses_mailbox()) scratch.mailbox.forget();
    if (!membership_.made_for(incoming)) [[unlikely]]
        return trace_from_afar<Q>(search);
    const Interval inside = clip(ray, space_, {incoming.t_min, hit.t});
    if (!inside.empty()) enter<Q>(grids_.front(), inside.entry, search);
}

/// By all cells, in whatever grid, of the runs whose outlines the ray meets.
template <Query Q, Counter C>
void Grid::trace_from_afar(Search<C>& search) const {
    const auto visit = [&](std::uint32_t cell) {
        const CellWord word = cells_[cell];
        if (!word.is_leaf()) return false;
        search.count(Event::cell);
        leaves_.template test<Q>(word, search.ray, search.hit, search.scratch.mailbox,
                                 search.count);
        return over<Q>(search.hit);
    };
    outlines_.each(search.ray, search.ray.t_min, search.hit, visit, search.count);
}

/// At t the ray comes into a grid.
template <Query Q, Counter C>
inline void Grid::enter(const SubGrid& grid, float t, Search<C>& search) const {
    if (search.along_planes && runs_in_a_plane(grid.lattice, search.ray)) [[unlikely]]
        return walk_layers<Q>(grid, search);
    walk<Q>(grid, t, search);
}

/// Cell by cell. A hit in a cell is final only if it lies before the cell's end: closed, as an
/// equal one with a smaller number may lie in the next.
template <Query Q, Counter C>
inline void Grid::walk(const SubGrid& grid, float t, Search<C>& search) const {
    Walk walk(grid.lattice, search.ray, t);
    while (true) {
        const CellWord word = visit<Q>(grid, walk.cell(), t, search);
        if (over<Q>(search.hit)) return;
        if (skip_ != Skip::none && word.is_empty() && word.clearance() > 0)
            walk.leap(empty_round(skip_, grid.lattice, walk.cell(), word));
        t = walk.exit();
        if (search.hit.t < t) return;
        const unsigned axes = walk.axes_out();
        const bool inside =
            std::has_single_bit(axes)
                ? walk.step(std::countr_zero(axes))
                : walk.cross_block([&](const Cell& cell) { visit<Q>(grid, cell, t, search); });
        if (!inside) return;
    }
}

template <Query Q, Counter C>
void Grid::walk_layers(const SubGrid& grid, Search<C>& search) const {
    Layers(grid.lattice, search.ray)
        .walk(
            search.ray.t_min, [&](const Cell& cell, float t) { visit<Q>(grid, cell, t, search); },
            [&] { return over<Q>(search.hit) ? -infinity : search.hit.t; });
}

/// What is in a cell that the ray comes to at t; returns the cell's word.
template <Query Q, Counter C>
inline CellWord Grid::visit(const SubGrid& grid, const Cell& cell, float t,
                            Search<C>& search) const {
    const CellWord word = cells_[grid.first_cell + grid.lattice.number(cell)];
    if (over<Q>(search.hit)) return word;  // in the middle of a block
    search.count(Event::step);
    if (word.is_leaf()) {
        search.count(Event::cell);
        leaves_.template test<Q>(word, search.ray, search.hit, search.scratch.mailbox,
                                 search.count);
    } else if (word.is_empty()) {
        search.count(Event::cell);
        search.count(Event::empty_cell);
    } else {
        enter<Q>(grids_[word.grid()], t, search);
    }
    return word;
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

#include "accel/grid/abreast.h"
#include "accel/grid/together.h"
