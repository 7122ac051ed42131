#include "accel/grid/walk.h"

#include <gtest/gtest.h>

#include <set>

#include "accel/grid/layers.h"
#include "tests/contract/random.h"

namespace rayshoot::grid_test {
namespace {

constexpr int along = 12;

Lattice lattice() { return Lattice({vec3(-1), vec3(1)}, {along, along, along}); }

struct Line {
    vec3 origin, direction;
};

/// From within, from outside, along axes and diagonals, through edges and corners of cells.
Line random_line(contract::Random& random, const Lattice& cells) {
    const auto plane = [&](int axis) {
        return cells.plane(axis, static_cast<int>(random.below(along + 1)));
    };
    Line line{random.power_of_two(-1, 3) * random.direction(), random.direction()};
    if (random.coin()) line.origin = {plane(0), plane(1), plane(2)};
    if (random.coin()) line.direction = vec3(plane(0), plane(1), plane(2)) - line.origin;
    for (int axis = 0; axis < 3; ++axis)
        if (random.below(4) == 0) line.direction[axis] = 0;
    if (random.below(8) == 0) line.direction = {1, 1, -1};
    if (line.direction == vec3(0)) line.direction.x = -1;
    return line;
}

/// All cells whose closed box the ray touches from t_min on, by the slab form.
std::set<Cell> touched(const Lattice& cells, const SlabRay& ray, float t_min) {
    std::set<Cell> result;
    for_each_cell({{0, 0, 0}, cells.last()}, [&](const Cell& cell) {
        if (!clip(ray, cells.box(cell), {t_min, infinity}).empty()) result.insert(cell);
    });
    return result;
}

bool runs_in_a_plane(const Lattice& cells, const Line& line) {
    for (int axis = 0; axis < 3; ++axis)
        if (line.direction[axis] == 0 && cells.on_plane(axis, line.origin[axis])) return true;
    return false;
}

/// In the order of the walk.
std::vector<Cell> walked(const Lattice& cells, const SlabRay& ray, float t) {
    std::vector<Cell> visited;
    Walk walk(cells, ray, t);
    for (bool inside = true; inside;) {
        visited.push_back(walk.cell());
        const unsigned out = walk.axes_out();
        inside = std::has_single_bit(out)
                     ? walk.step(std::countr_zero(out))
                     : walk.cross_block([&](const Cell& cell) { visited.push_back(cell); });
        if (inside && !visited.empty() && visited.back() == walk.cell()) visited.pop_back();
    }
    return visited;
}

TEST(Walk, visits_cells_in_the_right_order) {
    contract::Random random(1);
    const Lattice cells = lattice();
    for (int i = 0; i < 3000; ++i) {
        const Line line = random_line(random, cells);
        const SlabRay ray(line.origin, line.direction);
        const Interval inside = clip(ray, {vec3(-1), vec3(1)}, {0, infinity});
        if (inside.empty() || runs_in_a_plane(cells, line)) continue;
        float entry = inside.entry;
        for (const Cell& cell : walked(cells, ray, inside.entry)) {
            const float next = clip(ray, cells.box(cell), {0, infinity}).entry;
            EXPECT_GE(next, entry);
            entry = next;
        }
    }
}

TEST(Walk, visits_every_cell_that_a_ray_touches_and_no_other) {
    contract::Random random(2);
    const Lattice cells = lattice();
    int several = 0;
    for (int i = 0; i < 3000; ++i) {
        const Line line = random_line(random, cells);
        const SlabRay ray(line.origin, line.direction);
        const Interval inside = clip(ray, {vec3(-1), vec3(1)}, {0, infinity});
        if (inside.empty() || runs_in_a_plane(cells, line)) continue;
        const std::set<Cell> expected = touched(cells, ray, 0);
        const std::vector<Cell> visited = walked(cells, ray, inside.entry);
        EXPECT_EQ(std::set<Cell>(visited.begin(), visited.end()), expected) << i;
        several += expected.size() > 1;
    }
    EXPECT_GT(several, 500);
}

TEST(Walk, leaps_over_empty_cells_to_where_single_steps_would_come) {
    contract::Random random(3);
    const Lattice cells = lattice();
    for (int i = 0; i < 2000; ++i) {
        const SlabRay ray(2.0f * random.direction(), random.direction());
        const Interval inside = clip(ray, {vec3(-1), vec3(1)}, {0, infinity});
        if (inside.empty()) continue;
        Walk leaping(cells, ray, inside.entry);
        const int reach = 1 + static_cast<int>(random.below(4));
        CellRange range;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            range.first[axis] = std::max(0, leaping.cell()[axis] - reach);
            range.last[axis] = std::min(along - 1, leaping.cell()[axis] + reach);
        }
        Walk stepping = leaping;
        const auto within = [&](const Cell& cell) {
            for (std::size_t axis = 0; axis < 3; ++axis)
                if (cell[axis] < range.first[axis] || cell[axis] > range.last[axis]) return false;
            return true;
        };
        Cell last = stepping.cell();
        while (std::has_single_bit(stepping.axes_out()) &&
               stepping.step(std::countr_zero(stepping.axes_out())) && within(stepping.cell()))
            last = stepping.cell();
        leaping.leap(range);
        EXPECT_EQ(leaping.cell(), last);
    }
}

/// Rays in faces and along edges, which touch two or four rows of cells all the way.
TEST(Layers, visit_every_cell_that_a_ray_touches) {
    contract::Random random(4);
    const Lattice cells = lattice();
    int in_planes = 0;
    for (int i = 0; i < 4000; ++i) {
        const Line line = random_line(random, cells);
        const SlabRay ray(line.origin, line.direction);
        in_planes += runs_in_a_plane(cells, line);
        std::set<Cell> visited;
        float before = -infinity;
        Layers(cells, ray)
            .walk(
                0,
                [&](const Cell& cell, float t) {
                    visited.insert(cell);
                    EXPECT_GE(t, before);
                    before = t;
                },
                [] { return infinity; });
        EXPECT_EQ(visited, touched(cells, ray, 0)) << i;
    }
    EXPECT_GT(in_planes, 300);
}

}  // namespace
}  // namespace rayshoot::grid_test
