#pragma once

#include "accel/core/session.h"
#include "accel/grid/cell_leaves.h"
#include "accel/grid/layers.h"
#include "accel/grid/walk.h"

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
        OptionInfo{"density", "0.01 to 64", "4", "cells per primitive"},
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
        OptionInfo{"bound", "1 to 100000", "64", "most references per primitive, by boxes"}};
    static constexpr std::array<std::string_view, 14> configurations{
        "grid",
        "grid:resolution=woo,density=1,overlap=havran,leaves=single,skip=none",
        "grid:resolution=klimaszewski,density=10,overlap=bounds,skip=macro",
        "grid:resolution=35x35x35,overlap=havran,leaves=single,skip=none",
        "grid:density=1,overlap=bounds,leaves=single,mailbox=on,skip=none",
        "grid:density=8,overlap=exact,leaves=single,mailbox=on,skip=distance",
        "grid:density=0.1,overlap=bounds,skip=none",
        "grid:resolution=1x1x1",
        "grid:overlap=bounds,bound=1",
        "grid:density=3,overlap=havran,leaves=single,skip=none,nested=recursive",
        "grid:density=2,overlap=exact,nested=recursive,leaf=2,skip=macro",
        "grid:density=2.4,nested=two_level",
        "grid:density=2.4,overlap=bounds,nested=two_level,top=1,leaf=1,skip=none",
        "grid:density=3,overlap=bounds,nested=recursive,leaf=1,depth=6,bound=3"};

    struct Scratch {
        Mailbox mailbox;
    };

    Grid(const BuildInput& input, const Options& chosen);

    template <Query Q, Counter C>
    bool one(const Ray& ray, Source, Hit& hit, Scratch& scratch, C& count) const;
    Footprint footprint() const { return footprint_; }

private:
    /// A ray on its way, with what it found.
    template <Counter C>
    struct Search {
        const TestRay& ray;
        float extra;  ///< by which cells are grown for it
        bool along_planes;
        Hit& hit;
        Scratch& scratch;
        C& count;
    };

    template <Query Q>
    static bool over(const Hit& hit) {
        return Q == Query::occluded && hit.primitive != no_primitive;
    }
    template <Query Q, Counter C>
    void enter(const SubGrid& grid, float t, Search<C>& search) const;
    template <Query Q, Counter C>
    void walk(const SubGrid& grid, float t, Search<C>& search) const;
    template <Query Q, Counter C>
    [[gnu::noinline]] void walk_layers(const SubGrid& grid, Search<C>& search) const;
    template <Query Q, Counter C>
    CellWord visit(const SubGrid& grid, const Cell& cell, float t, Search<C>& search) const;
    bool runs_in_a_plane(const Lattice& lattice, const SlabRay& ray) const;

    Membership membership_;
    std::vector<SubGrid> grids_;
    PagedVector<CellWord> cells_;
    CellLeaves leaves_;
    Skip skip_ = Skip::none;
    Box space_;  ///< of the outermost grid's cells; empty where there are none
    Footprint footprint_;
};

template <Query Q, Counter C>
inline bool Grid::one(const Ray& incoming, Source, Hit& hit, Scratch& scratch, C& count) const {
    const TestRay ray = leaves_.prepared(incoming);
    const float extra = membership_.extra(incoming);
    const auto unbounded = [&](int axis) { return !(std::abs(ray.inverse[axis]) < infinity); };
    Search<C> search{ray, extra, unbounded(0) || unbounded(1) || unbounded(2), hit, scratch, count};
    if (leaves_.uses_mailbox()) scratch.mailbox.forget();
    if (grids_.empty()) return true;
    if (extra > 0) [[unlikely]] {
        walk_layers<Q>(grids_.front(), search);
        return true;
    }
    const Interval inside = clip(ray, space_, {incoming.t_min, hit.t});
    if (!inside.empty()) enter<Q>(grids_.front(), inside.entry, search);
    return true;
}

/// At t the ray comes into a grid.
template <Query Q, Counter C>
inline void Grid::enter(const SubGrid& grid, float t, Search<C>& search) const {
    if (search.extra > 0 || (search.along_planes && runs_in_a_plane(grid.lattice, search.ray)))
        [[unlikely]]
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
    Layers(grid.lattice, search.ray, search.extra)
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
