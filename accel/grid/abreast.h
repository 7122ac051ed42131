#pragma once

#include "accel/grid/grid.h"

/// Rays side by side: those in cells with nothing step together, those at leaves wait until as many
/// have come as fill a register, each with a block of its own.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Query Q, Counter C>
void Grid::trace_abreast(const Part& part, Answers<Q>& answers, Scratch& scratch, C& count) const {
    Flock& flock = scratch.flock;
    const SubGrid& grid = grids_.front();
    LaneSet idle = (LaneSet{1} << Flock::size) - 1, walking = 0, waiting = 0;
    const auto finish = [&](std::size_t lane) {
        answers.store(flock.number(lane), flock.hit(lane));
        idle |= LaneSet{1} << lane;
    };
    const auto came_to_cells = [&](LaneSet moved, LaneSet arrived) {
        if constexpr (C::counts) {
            const auto empty = static_cast<std::uint64_t>(std::popcount(moved & ~arrived));
            count(Event::step, static_cast<std::uint64_t>(std::popcount(moved)));
            count(Event::cell, empty);
            count(Event::empty_cell, empty);
        }
        for_each_lane(arrived, [&](std::size_t lane) { fetch(flock.word(lane)); });
        walking |= moved & ~arrived;
        waiting |= arrived;
    };
    for (std::size_t next = 0;;) {
        for_each_lane(idle, [&](std::size_t lane) {
            while (next < part.rays.size()) {
                const std::size_t number = next++;
                if (!start<Q>(part.rays[number], part.first + number, lane, answers, scratch,
                              count))
                    continue;
                const LaneSet self = LaneSet{1} << lane;
                idle &= ~self;
                return came_to_cells(self, flock.word(lane).is_empty() ? 0 : self);
            }
        });
        if ((walking | waiting) == 0) return;
        // Until half of them wait: fewer would leave lanes without work for too long.
        const int live = std::popcount(walking | waiting);
        while (walking != 0 && 2 * std::popcount(walking) >= live)
            for (std::size_t first = 0; first < Flock::size; first += Flock::width) {
                const LaneSet lanes = ((LaneSet{1} << Flock::width) - 1) << first;
                if ((walking & lanes) == 0) continue;
                const auto stepped =
                    flock.step(first, walking & lanes, grid.lattice, cells_.data());
                walking &= ~lanes;
                came_to_cells(stepped.moved, stepped.arrived);
                for_each_lane(stepped.tied, [&](std::size_t lane) {
                    Search<C> search =
                        search_for(flock.ray(lane), 0, flock.hit(lane), scratch, count);
                    walk<Q>(grid, flock.t(lane), search);
                    finish(lane);
                });
                for_each_lane(stepped.ended, finish);
            }
        const LaneSet on = visit_leaves<Q>(std::exchange(waiting, 0), scratch, count);
        for_each_lane(on, [&](std::size_t lane) {
            if (over<Q>(flock.hit(lane))) return finish(lane);
            flock.update(lane);
            walking |= LaneSet{1} << lane;
        });
    }
}

/// Puts a ray into a lane; false if it needs none: it misses the grid, or has to go alone.
template <Query Q, Counter C>
inline bool Grid::start(const Ray& incoming, std::size_t number, std::size_t lane,
                        Answers<Q>& answers, Scratch& scratch, C& count) const {
    const SubGrid& grid = grids_.front();
    const TestRay ray = leaves_.prepared(incoming);
    Hit hit = nothing_yet(incoming);
    const Search<C> search = search_for(ray, membership_.extra(incoming), hit, scratch, count);
    const bool alone = search.extra > 0 || !nearby_.contains(incoming.origin) ||
                       (search.along_planes && runs_in_a_plane(grid.lattice, ray));
    if (alone) [[unlikely]] {
        trace_alone<Q>(incoming, hit, scratch, count);
    } else {
        const Interval inside = clip(ray, space_, {incoming.t_min, hit.t});
        if (!inside.empty()) {
            scratch.flock.start(lane, incoming, ray, hit, static_cast<std::uint32_t>(number),
                                grid.lattice, inside.entry, cells_.data());
            return true;
        }
    }
    answers.store(number, hit);
    return false;
}

/// All leaves, and grids, that rays wait at. Returns the rays.
template <Query Q, Counter C>
inline LaneSet Grid::visit_leaves(LaneSet lanes, Scratch& scratch, C& count) const {
    Flock& flock = scratch.flock;
    LaneSet triangles = 0, spheres = 0;
    for_each_lane(lanes, [&](std::size_t lane) {
        const CellWord word = flock.word(lane);
        const LaneSet self = LaneSet{1} << lane;
        if (!word.is_leaf() || PackedLeaf::from(word.leaf()).is_mixed())
            return visit_other<Q>(lane, scratch, count);
        count(Event::cell);
        (PackedLeaf::from(word.leaf()).only_triangles() ? triangles : spheres) |= self;
    });
    visit_blocks<Q, TriangleBlock>(triangles, flock, count);
    visit_blocks<Q, SphereBlock>(spheres, flock, count);
    return lanes;
}

template <Query Q, Counter C>
void Grid::visit_other(std::size_t lane, Scratch& scratch, C& count) const {
    Flock& flock = scratch.flock;
    const CellWord word = flock.word(lane);
    Search<C> search = search_for(flock.ray(lane), 0, flock.hit(lane), scratch, count);
    if (!word.is_leaf()) return enter<Q>(grids_[word.grid()], flock.t(lane), search);
    count(Event::cell);
    leaves_.template test<Q>(word, search.ray, search.hit, scratch.mailbox, count);
}

/// As many rays at once as fill a register, each with a block of its own leaf.
template <Query Q, class Block, Counter C>
inline void Grid::visit_blocks(LaneSet lanes, Flock& flock, C& count) const {
    const PackedLeaves& leaves = leaves_.packed();
    const float padding = leaves.padding();
    while (lanes != 0) {
        RaysAndBlocks<Block> pairs;
        std::array<std::size_t, rays_by_blocks> numbers;
        std::size_t together = 0;
        for (; together < rays_by_blocks && lanes != 0; ++together, lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            const PackedLeaf leaf = PackedLeaf::from(flock.word(lane).leaf());
            numbers[together] = lane;
            pairs[together] = {&flock.ray(lane), &flock.hit(lane),
                               &leaves.block<Block>(leaf.first_block())};
        }
        constexpr Misses misses = Misses::leave;  // most blocks are missed
        if constexpr (std::is_same_v<Block, SphereBlock>)
            rayshoot::test<misses>(pairs, together, padding, count);
        else if (leaves.precision() == Precision::standard)
            rayshoot::test<Precision::standard, misses>(pairs, together, padding, count);
        else rayshoot::test<Precision::watertight, misses>(pairs, together, padding, count);
        for (std::size_t i = 0; i < together; ++i) {
            const PackedLeaf leaf = PackedLeaf::from(flock.word(numbers[i]).leaf());
            if (leaf.block_count() == 1 || over<Q>(flock.hit(numbers[i]))) continue;
            flock.set_word(numbers[i], CellWord::leaf(leaf.after_first().bits()));
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
