#include "accel/grid/sweep.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/contract/random.h"

namespace rayshoot::grid_test {
namespace {

constexpr Cell along{24, 17, 31};

Lattice lattice() { return Lattice({vec3(-1, -1, -0.5f), vec3(1, 0.7f, 1)}, along); }

/// From near each other towards points near each other, within the lattice or without.
std::vector<Ray> coherent_rays(contract::Random& random, std::size_t count) {
    const float apart = random.power_of_two(-8, -3);
    const vec3 from = random.power_of_two(-2, 4) * random.direction();
    const vec3 towards = random.inside({vec3(-1, -1, -0.5f), vec3(1, 0.7f, 1)});
    std::vector<Ray> rays(count);
    for (Ray& ray : rays) {
        ray.origin = from + apart * random.direction();
        ray.direction = towards + apart * random.direction() - ray.origin;
    }
    return rays;
}

std::optional<Sweep> sweep_of(Packet& packet, const std::vector<Ray>& rays, const Lattice& cells) {
    if (!packet.load(rays, Precision::standard, infinity)) return std::nullopt;
    return Sweep::of(packet, packet.beam(packet.all()), cells);
}

TEST(Sweep, misses_no_cell_that_a_ray_of_the_packet_touches) {
    contract::Random random(1);
    const Lattice cells = lattice();
    Packet packet;
    int swept_packets = 0;
    for (int i = 0; i < 400; ++i) {
        const std::vector<Ray> rays = coherent_rays(random, i % 2 == 0 ? 64 : 16);
        std::optional<Sweep> sweep = sweep_of(packet, rays, cells);
        if (!sweep) continue;
        ++swept_packets;
        std::set<Cell> swept;
        for (; sweep->inside(); sweep->advance(1))
            if (const auto range = sweep->cells())
                for_each_cell(*range, [&](const Cell& cell) { swept.insert(cell); });
        for_each_cell({{0, 0, 0}, cells.last()}, [&](const Cell& cell) {
            if (swept.contains(cell)) return;
            for (const Ray& ray : rays) {
                const SlabRay slabs(ray.origin, ray.direction);
                const Interval touched = clip(slabs, cells.box(cell), {ray.t_min, infinity});
                // What is touched at t_min alone holds no hit: those come after it.
                EXPECT_FALSE(touched.entry <= touched.exit && touched.exit > ray.t_min);
            }
        });
    }
    EXPECT_GT(swept_packets, 100);
}

TEST(Sweep, skips_no_slice_that_is_not_within_the_clearance) {
    contract::Random random(2);
    const Lattice cells = lattice();
    Packet packet;
    for (int i = 0; i < 400; ++i) {
        std::optional<Sweep> sweep = sweep_of(packet, coherent_rays(random, 16), cells);
        for (; sweep && sweep->inside(); sweep->advance(1)) {
            const auto here = sweep->cells();
            if (!here) continue;
            const int clearance = 1 + static_cast<int>(random.below(8));
            Sweep next = *sweep;
            for (int k = sweep->slices_within(clearance); k > 0; --k) {
                next.advance(1);
                const auto there = next.inside() ? next.cells() : std::nullopt;
                for (std::size_t axis = 0; there && axis < 3; ++axis) {
                    EXPECT_GE(there->first[axis], here->first[axis] - clearance);
                    EXPECT_LE(there->last[axis], here->last[axis] + clearance);
                }
            }
        }
    }
}

}  // namespace
}  // namespace rayshoot::grid_test
