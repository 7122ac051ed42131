#include <gtest/gtest.h>

#include "accel/core/catalogue.h"
#include "accel/core/intersector.h"
#include "accel/grid/lattice.h"
#include "tests/contract/scenes/shapes.h"
#include "tests/contract/truth.h"

/// The rules that every subdivision of space must keep, on scenes made to break each.
namespace rayshoot::grid_test {
namespace {

using contract::Random;
using contract::Truth;

constexpr std::array specs{
    "grid:resolution=8x8x8,overlap=bounds", "grid:resolution=8x8x8,overlap=exact,abreast=off",
    "grid:resolution=8x8x8,overlap=exact,leaves=single,mailbox=on,skip=none",
    "grid:resolution=8x8x8,overlap=havran,leaves=single,skip=macro",
    "grid:resolution=2x2x2,nested=recursive,density=64,leaf=1,overlap=bounds"};

void expect_the_truth(const Geometry& geometry, std::span<const Ray> rays) {
    const Truth truth(geometry);
    std::vector<Hit> expected;
    for (const Ray& ray : rays) expected.push_back(truth.closest(ray));
    for (const char* spec : specs) {
        const auto accel = build(built_in_catalogue(), spec, {geometry});
        const auto session = accel->open(Mode::timing);
        for (std::size_t i = 0; i < rays.size(); i += default_batch) {
            const RayBatch batch{.rays = rays.subspan(i, std::min(default_batch, rays.size() - i))};
            std::vector<Hit> hits(batch.rays.size());
            std::vector<std::uint8_t> occluded(batch.rays.size());
            session->closest(batch, hits);
            session->occluded(batch, occluded);
            for (std::size_t j = 0; j < hits.size(); ++j) {
                ASSERT_EQ(hits[j], expected[i + j]) << spec << ", ray " << i + j;
                ASSERT_EQ(occluded[j], expected[i + j].primitive != no_primitive) << spec;
            }
        }
    }
}

/// Corners that make the scene a cube of side 2 round the origin.
void add_frame(GeometryBuilder& builder) {
    builder.add_triangle(vec3(-1), vec3(-1), vec3(-0.999f, -1, -1));
    builder.add_triangle(vec3(1), vec3(1), vec3(0.999f, 1, 1));
}

Ray towards(const vec3& from, const vec3& target) {
    Ray ray;
    ray.origin = from;
    ray.direction = target - from;
    return ray;
}

std::vector<Ray> rays_through(Random& random, int count) {
    const Box box{vec3(-1), vec3(1)};
    std::vector<Ray> rays;
    for (int i = 0; i < count; ++i)
        rays.push_back(towards(3.0f * random.direction(), random.inside(box)));
    return rays;
}

TEST(GridRules, cells_in_the_right_order) {
    GeometryBuilder builder;
    for (int i = 0; i < 16; ++i)  // walls across each axis, one in each cell and two behind
        for (int axis = 0; axis < 3; ++axis) {
            vec3 corner(-1), u(0), v(0);
            corner[axis] = -0.95f + 0.12f * static_cast<float>(i);
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 2;
            contract::add_quad(builder, corner, u, v);
        }
    const Geometry geometry = std::move(builder).build();
    Random random(1);
    expect_the_truth(geometry, rays_through(random, 4000));
}

TEST(GridRules, all_objects_of_a_cell_and_the_nearest_kept) {
    GeometryBuilder builder;
    add_frame(builder);
    Random random(2);
    contract::add_soup(builder, random, {vec3(0.01f), vec3(0.2f)}, 0.03f, 300);
    const Geometry geometry = std::move(builder).build();
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i)
        rays.push_back(towards(random.direction(), random.inside({vec3(0), vec3(0.2f)})));
    expect_the_truth(geometry, rays);
}

TEST(GridRules, a_hit_counts_only_when_no_earlier_cell_can_hold_a_nearer_one) {
    GeometryBuilder builder;
    add_frame(builder);
    // Long ones are met in the first cell they share with the ray, far behind small ones that
    // stand in cells between.
    Random random(3);
    for (int i = 0; i < 40; ++i) {
        const float x = random.between(-0.9f, 0.9f), y = random.between(-0.9f, 0.9f);
        builder.add_triangle({-1, y, x}, {1, y + 0.05f, -x}, {1, y - 0.05f, -x});
        builder.add_triangle({x, y, -0.2f}, {x + 0.02f, y, -0.2f}, {x, y + 0.02f, -0.2f});
    }
    const Geometry geometry = std::move(builder).build();
    std::vector<Ray> rays = rays_through(random, 3000);
    for (int i = 0; i < 3000; ++i)
        rays.push_back(towards({-2, random.between(-1, 1), random.between(-0.1f, 0.1f)},
                               {1, random.between(-1, 1), random.between(-1, 1)}));
    expect_the_truth(geometry, rays);
}

/// Quads whose edges and faces lie in the planes between cells, met in those planes.
TEST(GridRules, objects_that_straddle_or_lie_in_a_boundary_are_never_lost) {
    GeometryBuilder builder;
    add_frame(builder);
    for (int i = -3; i <= 3; ++i)
        for (int axis = 0; axis < 3; ++axis) {
            vec3 corner(-0.75f), u(0), v(0);
            corner[axis] = 0.25f * static_cast<float>(i);
            u[(axis + 1) % 3] = v[(axis + 2) % 3] = 0.25f + 0.125f * static_cast<float>(i + 3);
            contract::add_quad(builder, corner, u, v);
        }
    const Geometry geometry = std::move(builder).build();
    Random random(4);
    const auto plane = [&] { return 0.25f * static_cast<float>(random.below(9)) - 1; };
    std::vector<Ray> rays = rays_through(random, 2000);
    for (int i = 0; i < 6000; ++i) {
        Ray ray = towards({plane(), plane(), plane()}, {plane(), plane(), plane()});
        if (random.coin()) ray.direction[static_cast<int>(random.below(3))] = 0;
        if (random.coin()) ray.origin -= 4.0f * ray.direction;
        if (random.below(4) == 0) ray.direction = -ray.direction;
        rays.push_back(ray);
    }
    expect_the_truth(geometry, rays);
}

/// From where neighbouring planes round to one t, so that whole blocks of cells are tied.
TEST(GridRules, rays_from_a_million_sizes_away_lose_nothing) {
    GeometryBuilder builder;
    Random random(5);
    contract::add_soup(builder, random, {vec3(-1), vec3(1)}, 0.2f, 500);
    const Geometry geometry = std::move(builder).build();
    std::vector<Ray> rays;
    for (const float away : {1e3f, 1e6f, 3e7f})
        for (int i = 0; i < 700; ++i) {
            const vec3 target = random.inside({vec3(-1), vec3(1)});
            rays.push_back(towards(target + away * random.direction(), target));
            Ray along_axis;
            along_axis.direction = vec3(random.coin(), random.coin(), 1);
            along_axis.origin = target - away * along_axis.direction;
            rays.push_back(along_axis);
        }
    expect_the_truth(geometry, rays);
}

}  // namespace
}  // namespace rayshoot::grid_test
