#include "accel/grid/flock.h"

#include <gtest/gtest.h>

#include "tests/contract/random.h"

namespace rayshoot::grid_test {
namespace {

constexpr int along = 20;

/// Each cell's word is a leaf with the cell's number, or, at random, empty with nothing round it.
std::vector<CellWord> numbered(const Lattice& lattice, contract::Random& random) {
    std::vector<CellWord> cells;
    for (std::uint32_t i = 0; i < lattice.size(); ++i)
        cells.push_back(random.coin() ? CellWord::leaf(i) : CellWord::empty());
    return cells;
}

TEST(Flock, steps_every_lane_through_the_cells_that_a_walk_visits) {
    contract::Random random(1);
    const Lattice lattice({vec3(-1), vec3(1)}, {along, along, along});
    const std::vector<CellWord> cells = numbered(lattice, random);
    const Box space{lattice.lo(), lattice.box(lattice.last()).hi};
    for (int i = 0; i < 200; ++i) {
        Flock flock{};
        std::vector<std::optional<Walk>> walks(Flock::size);
        std::vector<TestRay> rays;
        for (std::size_t lane = 0; lane < Flock::size; ++lane) {
            Ray ray;
            ray.origin = random.power_of_two(-1, 6) * random.direction();
            ray.direction = random.inside(space) - ray.origin;
            if (random.below(4) == 0) ray.direction[static_cast<int>(random.below(3))] = 0;
            rays.emplace_back(ray, Precision::standard);
        }
        LaneSet walking = 0;
        for (std::size_t lane = 0; lane < Flock::size; ++lane) {
            const TestRay& ray = rays[lane];
            const Interval inside = clip(ray, space, {0, infinity});
            if (inside.empty()) continue;
            Ray from;
            from.origin = ray.origin;
            from.direction = ray.direction;
            flock.start(lane, from, ray, nothing_yet(from), 0, lattice, inside.entry, cells.data());
            walks[lane].emplace(lattice, ray, inside.entry);
            walking |= LaneSet{1} << lane;
        }
        while (walking != 0)
            for (std::size_t first = 0; first < Flock::size; first += Flock::width) {
                const LaneSet lanes = walking & (((LaneSet{1} << Flock::width) - 1) << first);
                if (lanes == 0) continue;
                const auto stepped = flock.step(first, lanes, lattice, cells.data());
                simd::for_each(lanes, [&](std::size_t lane) {
                    Walk& walk = *walks[lane];
                    const unsigned out = walk.axes_out();
                    const LaneSet self = LaneSet{1} << lane;
                    EXPECT_EQ(!std::has_single_bit(out), (stepped.tied & self) != 0);
                    if (!std::has_single_bit(out)) return;
                    const float t = walk.exit();
                    const bool left = !walk.step(std::countr_zero(out));
                    EXPECT_EQ(left, (stepped.ended & self) != 0);
                    if (left) return;
                    const CellWord word = cells[lattice.number(walk.cell())];
                    EXPECT_EQ(flock.t(lane), t);
                    EXPECT_EQ(flock.word(lane).bits(), word.bits());
                    EXPECT_EQ(!word.is_empty(), (stepped.arrived & self) != 0);
                });
                walking &= ~(stepped.ended | stepped.tied);
            }
    }
}

}  // namespace
}  // namespace rayshoot::grid_test
