#include "accel/grid/lattice.h"

#include <gtest/gtest.h>

#include "accel/grid/resolution.h"
#include "tests/contract/random.h"

namespace rayshoot::grid_test {
namespace {

Lattice random_lattice(contract::Random& random) {
    const float scale = random.power_of_two(-20, 20), aside = random.power_of_two(-10, 24);
    Box space;
    space.include(aside * random.direction());
    space.include(space.lo + scale * (vec3(1) + random.direction()));
    const auto cells = [&] { return static_cast<int>(1 + random.below(200)); };
    return Lattice(space, {cells(), cells(), cells()});
}

TEST(Lattice, covers_its_box_with_planes_in_order) {
    contract::Random random(1);
    for (int i = 0; i < 2000; ++i) {
        const vec3 from = random.power_of_two(-126, 126) * random.direction();
        Box space{from, from};
        space.include(from + random.power_of_two(-126, 126) * random.direction());
        const auto cells = static_cast<int>(1 + random.below(300));
        const Lattice lattice(space, {cells, cells, cells});
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(lattice.plane(axis, 0), space.lo[axis]);
            const int last = lattice.cells()[static_cast<std::size_t>(axis)];
            EXPECT_GE(lattice.plane(axis, last), space.hi[axis]);
            for (int k = 0; k < last; ++k)
                ASSERT_LE(lattice.plane(axis, k), lattice.plane(axis, k + 1));
        }
    }
}

TEST(Lattice, neighbouring_cells_share_a_plane_bit_for_bit) {
    contract::Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Lattice lattice = random_lattice(random);
        for (int x = 1; x < lattice.cells()[0]; ++x)
            EXPECT_EQ(lattice.box({x - 1, 0, 0}).hi.x, lattice.box({x, 0, 0}).lo.x);
    }
}

TEST(Lattice, knows_all_closed_cells_that_touch_a_box) {
    contract::Random random(3);
    for (int i = 0; i < 300; ++i) {
        const Lattice lattice = random_lattice(random);
        const int axis = static_cast<int>(random.below(3));
        const int cells = lattice.cells()[static_cast<std::size_t>(axis)];
        const auto pick = [&] {
            const auto k = static_cast<int>(random.below(static_cast<std::uint32_t>(cells + 1)));
            const float plane = lattice.plane(axis, k);
            return random.coin() ? plane : random.coin() ? float_above(plane) : float_below(plane);
        };
        float lo = pick(), hi = pick();
        if (lo > hi) std::swap(lo, hi);
        const int first = lattice.first(axis, lo), last = lattice.last(axis, hi);
        for (int k = 0; k < cells; ++k) {
            const bool touches = lattice.plane(axis, k) <= hi && lattice.plane(axis, k + 1) >= lo;
            const bool inside = lattice.plane(axis, 0) <= hi && lattice.plane(axis, cells) >= lo;
            if (touches || inside) {
                EXPECT_EQ(first <= k && k <= last, touches);
            }
        }
    }
}

Cell cells_of(const char* rule, const Box& box, double objects, double density) {
    static constexpr std::array known{OptionInfo{"resolution", "", "cleary", ""}};
    const Options options("grid", known, std::string("resolution=") + rule);
    return Resolution::chosen(options, "resolution").cells(box, objects, density);
}

TEST(Resolution, follows_the_published_formulas) {
    const Box cube{vec3(0), vec3(2)}, flat{vec3(0), vec3(24, 24, 1.353f)};
    EXPECT_EQ(cells_of("cleary", cube, 4096, 1), (Cell{16, 16, 16}));
    EXPECT_EQ(cells_of("woo", cube, 4096, 1), (Cell{16, 16, 16}));
    EXPECT_EQ(cells_of("woo", cube, 4096, 10), (Cell{34, 34, 34}));
    EXPECT_EQ(cells_of("cleary", flat, 7382, 1), (Cell{50, 50, 2}));
    EXPECT_EQ(cells_of("woo", flat, 7382, 1), (Cell{51, 51, 3}));
    // 133.1 cells along x, then sqrt(7382 * 24 / (x * 1.353)), then what is left.
    EXPECT_EQ(cells_of("klimaszewski", flat, 7382, 1), (Cell{51, 51, 3}));
    EXPECT_EQ(cells_of("46x46x3", flat, 7382, 10), (Cell{46, 46, 3}));
}

TEST(Resolution, gives_flat_and_long_boxes_as_many_cells_as_others) {
    for (const char* rule : {"cleary", "woo"})
        for (const vec3& size : {vec3(1), vec3(1, 1, 0), vec3(0, 0, 1), vec3(1, 1e-6f, 1e-3f)}) {
            const Cell cells = cells_of(rule, {vec3(0), size}, 1000, 4);
            const double product = double(cells[0]) * cells[1] * cells[2];
            EXPECT_GT(product, 1500) << rule;
            EXPECT_LT(product, 8000) << rule;
        }
}

TEST(Resolution, refuses_what_is_no_resolution) {
    for (const char* text : {"", "4x4", "4x4x", "0x4x4", "4x4x4x4", "99999x99999x99999", "wide"})
        EXPECT_THROW(cells_of(text, {vec3(0), vec3(1)}, 10, 1), std::invalid_argument) << text;
}

}  // namespace
}  // namespace rayshoot::grid_test
