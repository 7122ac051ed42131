#pragma once

#include "accel/grid/grid.h"

/// Rays side by side: those in cells with nothing step together, those at leaves wait until as many
/// have come as fill a register, each with a block of its own.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Counter C>
struct Grid::Abreast {
    const Grid& grid;
    const BatchPart& part;
    Answers<Q>& answers;
    Scratch& scratch;
    C& count;
    LaneSet idle = (LaneSet{1} << Flock::size) - 1, walking = 0, waiting = 0;
    std::size_t next = 0;  ///< the first ray that has not begun

    void trace() {
        while (true) {
            simd::for_each(idle, [&](std::size_t lane) { refill(lane); });
            if ((walking | waiting) == 0) return;
            step();
            visit_leaves();
        }
    }

    void refill(std::size_t lane);
    bool start(std::size_t number, std::size_t lane);
    void step();
    void came_to_cells(LaneSet moved, LaneSet arrived);
    void visit_leaves();
    template <class Block>
    void visit_blocks(LaneSet lanes);
    [[gnu::noinline]] void visit_other(std::size_t lane);
    [[gnu::noinline]] void go_alone(std::size_t lane);

    // What is called most has all that it calls inlined; the rest stays out of its way. Most blocks
    // are missed: their tests are left early.
    [[gnu::flatten]] void test_triangles(RaysAndBlocks<TriangleBlock>& pairs, std::size_t size) {
        rayshoot::test<Precision::standard, Misses::leave, Q>(pairs, size, padding(), count);
    }
    [[gnu::noinline]] void test_watertight_triangles(RaysAndBlocks<TriangleBlock>& pairs,
                                                     std::size_t size) {
        rayshoot::test<Precision::watertight, Misses::leave, Q>(pairs, size, padding(), count);
    }
    [[gnu::noinline]] void test_spheres(RaysAndBlocks<SphereBlock>& pairs, std::size_t size) {
        rayshoot::test<Misses::leave>(pairs, size, padding(), count);
    }
    float padding() const { return grid.leaves_.packed().padding(); }

    void finish(std::size_t lane) {
        answers.store(flock().number(lane), flock().hit(lane));
        idle |= LaneSet{1} << lane;
    }
    Flock& flock() const { return scratch.flock; }
    const SubGrid& outermost() const { return grid.grids_.front(); }
    Search<C> search(std::size_t lane) const {
        return grid.search_for(flock().ray(lane), flock().hit(lane), scratch, count);
    }
};

template <Query Q, Counter C>
inline void Grid::Abreast<Q, C>::refill(std::size_t lane) {
    while (next < part.rays.size()) {
        if (!start(next++, lane)) continue;
        const LaneSet self = LaneSet{1} << lane;
        idle &= ~self;
        return came_to_cells(self, flock().word(lane).is_empty() ? 0 : self);
    }
}

/// Puts a ray into a lane; false if it needs none: it misses the grid, or has to go alone.
template <Query Q, Counter C>
inline bool Grid::Abreast<Q, C>::start(std::size_t number, std::size_t lane) {
    const Ray& incoming = part.rays[number];
    const TestRay ray = grid.leaves_.prepared(incoming);
    Hit hit = nothing_yet(incoming);
    const Search<C> search = grid.search_for(ray, hit, scratch, count);
    const Lattice& lattice = outermost().lattice;
    const bool alone = !grid.membership_.made_for(incoming) ||
                       !grid.nearby_.contains(incoming.origin) ||
                       (search.along_planes && grid.runs_in_a_plane(lattice, ray));
    if (alone) [[unlikely]] {
        grid.trace_alone<Q>(incoming, hit, scratch, count);
    } else {
        const Interval inside = clip(ray, grid.space_, {incoming.t_min, hit.t});
        if (!inside.empty()) {
            flock().start(lane, incoming, ray, hit, static_cast<std::uint32_t>(part.first + number),
                          lattice, inside.entry, grid.cells_.data());
            return true;
        }
    }
    answers.store(part.first + number, hit);
    return false;
}

/// Until half of the rays wait: fewer that walk would leave lanes without work for too long.
template <Query Q, Counter C>
inline void Grid::Abreast<Q, C>::step() {
    constexpr LaneSet one_register = (LaneSet{1} << Flock::width) - 1;
    const int live = std::popcount(walking | waiting);
    while (walking != 0 && 2 * std::popcount(walking) >= live)
        for (std::size_t first = 0; first < Flock::size; first += Flock::width) {
            const LaneSet lanes = one_register << first;
            if ((walking & lanes) == 0) continue;
            const auto stepped =
                flock().step(first, walking & lanes, outermost().lattice, grid.cells_.data());
            walking &= ~lanes;
            came_to_cells(stepped.moved, stepped.arrived);
            simd::for_each(stepped.tied, [&](std::size_t lane) { go_alone(lane); });
            simd::for_each(stepped.ended, [&](std::size_t lane) { finish(lane); });
        }
}

template <Query Q, Counter C>
inline void Grid::Abreast<Q, C>::came_to_cells(LaneSet moved, LaneSet arrived) {
    if constexpr (C::counts) {
        const auto empty = static_cast<std::uint64_t>(std::popcount(moved & ~arrived));
        count(Event::step, static_cast<std::uint64_t>(std::popcount(moved)));
        count(Event::cell, empty);
        count(Event::empty_cell, empty);
    }
    simd::for_each(arrived, [&](std::size_t lane) { grid.fetch(flock().word(lane)); });
    walking |= moved & ~arrived;
    waiting |= arrived;
}

/// From where it is to its end.
template <Query Q, Counter C>
void Grid::Abreast<Q, C>::go_alone(std::size_t lane) {
    Search<C> rest = search(lane);
    grid.walk<Q>(outermost(), flock().t(lane), rest);
    finish(lane);
}

/// All leaves, and grids, that rays wait at.
template <Query Q, Counter C>
inline void Grid::Abreast<Q, C>::visit_leaves() {
    LaneSet triangles = 0, spheres = 0;
    simd::for_each(waiting, [&](std::size_t lane) {
        const CellWord word = flock().word(lane);
        const PackedLeaf leaf = PackedLeaf::from(word.leaf());
        if (!word.is_leaf() || leaf.is_mixed()) return visit_other(lane);
        count(Event::cell);
        (leaf.only_triangles() ? triangles : spheres) |= LaneSet{1} << lane;
    });
    visit_blocks<TriangleBlock>(triangles);
    visit_blocks<SphereBlock>(spheres);
    simd::for_each(std::exchange(waiting, 0), [&](std::size_t lane) {
        if (over<Q>(flock().hit(lane))) return finish(lane);
        flock().update(lane);
        walking |= LaneSet{1} << lane;
    });
}

template <Query Q, Counter C>
void Grid::Abreast<Q, C>::visit_other(std::size_t lane) {
    const CellWord word = flock().word(lane);
    Search<C> here = search(lane);
    if (!word.is_leaf()) return grid.enter<Q>(grid.grids_[word.grid()], flock().t(lane), here);
    count(Event::cell);
    grid.leaves_.template test<Q>(word, here.ray, here.hit, scratch.mailbox, count);
}

/// As many rays at once as fill a register, each with a block of its own leaf.
template <Query Q, Counter C>
template <class Block>
inline void Grid::Abreast<Q, C>::visit_blocks(LaneSet lanes) {
    const PackedLeaves& leaves = grid.leaves_.packed();
    while (lanes != 0) {
        RaysAndBlocks<Block> pairs;
        std::array<std::size_t, rays_by_blocks> numbers;
        std::size_t together = 0;
        for (; together < rays_by_blocks && lanes != 0; ++together, lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            const PackedLeaf leaf = PackedLeaf::from(flock().word(lane).leaf());
            numbers[together] = lane;
            pairs[together] = {&flock().ray(lane), &flock().hit(lane),
                               &leaves.block<Block>(leaf.first_block())};
        }
        if constexpr (std::is_same_v<Block, SphereBlock>) test_spheres(pairs, together);
        else if (leaves.precision() == Precision::standard) [[likely]]
            test_triangles(pairs, together);
        else test_watertight_triangles(pairs, together);
        for (std::size_t i = 0; i < together; ++i) {
            const PackedLeaf leaf = PackedLeaf::from(flock().word(numbers[i]).leaf());
            if (leaf.block_count() == 1 || over<Q>(flock().hit(numbers[i]))) continue;
            flock().set_word(numbers[i], CellWord::leaf(leaf.after_first().bits()));
            lanes |= LaneSet{1} << numbers[i];
        }
    }
}

/// Asks for a leaf's first block before its turn comes.
[[gnu::always_inline]] inline void Grid::fetch(CellWord word) const {
    const PackedLeaves& leaves = leaves_.packed();
    const std::byte* const first =
        leaves.first() + PackedLeaves::offset(PackedLeaf::from(word.leaf()));
    for (std::size_t i = 0; i < sizeof(LeafBlock); i += 64) __builtin_prefetch(first + i);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
