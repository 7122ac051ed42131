#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <numeric>

#include "accel/core/catalogue.h"
#include "accel/core/intersector.h"
#include "accel/grid/cell_lists.h"
#include "accel/grid/density.h"
#include "accel/grid/grid_tree.h"
#include "data/generators/generators.h"
#include "tests/contract/scenes/shapes.h"

namespace rayshoot::grid_test {
namespace {

Geometry soup(int count, float length) {
    GeometryBuilder builder;
    contract::Random random(7);
    contract::add_soup(builder, random, {vec3(-1), vec3(1)}, length, count);
    return std::move(builder).build();
}

std::vector<std::uint32_t> all_of(const Geometry& geometry) {
    std::vector<std::uint32_t> numbers(geometry.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

TEST(CellLists, hold_just_what_is_in_each_cell) {
    const Geometry geometry = soup(300, 0.3f);
    for (const Overlap overlap : {Overlap::bounds, Overlap::exact, Overlap::havran}) {
        const Membership membership({geometry}, overlap);
        const Lattice lattice(membership.space(), {7, 8, 9});
        const CellLists lists = list_members(membership, lattice, all_of(geometry));
        for_each_cell({{0, 0, 0}, lattice.last()}, [&](const Cell& cell) {
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < geometry.size(); ++i)
                if (membership.in_cell(i, lattice.box(cell))) expected.push_back(i);
            const auto members = lists.of(lattice.number(cell));
            EXPECT_TRUE(
                std::equal(members.begin(), members.end(), expected.begin(), expected.end()));
        });
    }
}

TEST(CellLists, are_fewer_by_exact_overlap) {
    const Geometry geometry = soup(300, 0.3f);
    const auto references = [&](Overlap overlap) {
        const Membership membership({geometry}, overlap);
        return list_members(membership, Lattice(membership.space(), {20, 20, 20}), all_of(geometry))
            .members.size();
    };
    EXPECT_LT(references(Overlap::exact), references(Overlap::bounds) * 3 / 4);
}

GridTree tree_of(const Geometry& geometry, GridSettings settings) {
    const Membership membership({geometry}, Overlap::exact);
    return build_grid_tree({geometry}, membership, settings);
}

TEST(GridTree, is_the_same_for_any_number_of_threads) {
    const Geometry geometry = soup(30000, 0.05f);
    const GridSettings settings{.resolution = {}, .levels = 3, .leaf = 4, .skip = Skip::distance};
    GridTree first;
    for (const std::size_t threads : {1u, 2u, 4u, 7u, 7u}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        GridTree tree = tree_of(geometry, settings);
        if (first.cells.empty()) {
            first = std::move(tree);
            continue;
        }
        EXPECT_EQ(tree.members, first.members);
        ASSERT_EQ(tree.cells.size(), first.cells.size());
        EXPECT_EQ(std::memcmp(tree.cells.data(), first.cells.data(),
                              tree.cells.size() * sizeof(CellWord)),
                  0);
    }
    EXPECT_GT(first.grids.size(), 1);
}

TEST(GridTree, divides_crowded_cells_down_to_its_levels) {
    const GridTree tree = tree_of(soup(2000, 0.2f), {.resolution = {},
                                                     .density = 2,
                                                     .top_density = 0.05,
                                                     .levels = 3,
                                                     .leaf = 4,
                                                     .bound = 1000});
    EXPECT_EQ(tree.depth, 3);
    EXPECT_TRUE(tree.remark.empty());
}

/// Cohen & Sheffer 1994: the chessboard distance to the nearest cell that is not empty.
TEST(Clearance, is_the_distance_to_the_nearest_occupied_cell) {
    const Lattice lattice({vec3(0), vec3(1)}, {70, 9, 11});
    contract::Random random(8);
    std::vector<CellWord> cells(lattice.size(), CellWord::empty());
    std::vector<Cell> occupied;
    for (int i = 0; i < 12; ++i) {
        const Cell cell{static_cast<int>(random.below(70)), static_cast<int>(random.below(9)),
                        static_cast<int>(random.below(11))};
        cells[lattice.number(cell)] = CellWord::leaf(static_cast<std::uint32_t>(i));
        occupied.push_back(cell);
    }
    measure_clearance(Skip::distance, lattice, cells);
    for_each_cell({{0, 0, 0}, lattice.last()}, [&](const Cell& cell) {
        int nearest = CellWord::most_clearance + 1;
        for (const Cell& other : occupied) {
            int distance = 0;
            for (std::size_t axis = 0; axis < 3; ++axis)
                distance = std::max(distance, std::abs(cell[axis] - other[axis]));
            nearest = std::min(nearest, distance);
        }
        const CellWord word = cells[lattice.number(cell)];
        EXPECT_EQ(word.is_empty(), nearest > 0);
        if (word.is_empty()) {
            EXPECT_EQ(word.clearance(), nearest - 1);
        }
    });
}

/// The formula of the README, over all primitives instead of a sample: a little apart.
TEST(Density, is_the_cheapest_of_the_powers_of_two) {
    for (const float length : {0.01f, 0.1f, 0.5f}) {
        const Geometry geometry = soup(3000, length);
        const Membership membership({geometry}, Overlap::bounds);
        const auto cost = [&](double density) {
            const Cell cells = Resolution{}.cells(membership.space(), 3000, density);
            const Lattice lattice(membership.space(), cells);
            const auto references = double(box_references(membership, lattice, all_of(geometry)));
            return double(lattice.box({0, 0, 0}).half_area()) *
                   (double(lattice.size()) + 1.5 * references);
        };
        const double chosen = cheapest_density(membership, {}, 3000);
        for (double density = 0.125; density <= 32; density *= 2)
            EXPECT_LE(cost(chosen), 1.03 * cost(density)) << length;
    }
}

Footprint footprint(const Geometry& geometry, const std::string& spec) {
    return build(built_in_catalogue(), spec, {geometry})->footprint();
}

TEST(Grid, keeps_references_below_its_bound_on_hostile_scenes) {
    GeometryBuilder coincident;
    for (int i = 0; i < 2000; ++i)
        coincident.add_triangle({-1, -1, -1}, {1, -0.9f, 1}, {-0.5f, 1, 0.3f});
    const Geometry same = std::move(coincident).build();
    const Scene needles = generate("needles", SceneOptions("needles", "count=2000"));
    for (const Geometry* geometry : {&same, &needles.geometry})
        for (const std::string spec :
             {"grid:bound=8,density=64", "grid:bound=8,density=64,overlap=bounds,nested=recursive",
              "grid:bound=8,density=64,nested=two_level"}) {
            const Footprint made = footprint(*geometry, spec);
            EXPECT_LE(*made.references, 8 * geometry->size() + 1000) << spec;
            EXPECT_NE(made.remark.find("bound on references"), std::string::npos) << spec;
        }
}

TEST(Grid, refuses_options_that_do_not_go_together) {
    const Geometry geometry = soup(10, 0.3f);
    EXPECT_THROW(footprint(geometry, "grid:mailbox=on"), std::invalid_argument);
    EXPECT_THROW(footprint(geometry, "grid:resolution=3x4"), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot::grid_test
