#include "accel/embree/direct.h"
#include "tests/yardsticks/scenes.h"

#include <gtest/gtest.h>

namespace rayshoot::yardsticks {
namespace {

TEST(EmbreeDirect, the_adaptor_gives_the_same_bits_as_direct_calls_on_every_path) {
    const Geometry geometry = bumpy_ball(12);
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::secondary}) {
        const std::vector<DirectRow> rows = measure_direct(geometry, kind, camera_rays(64), 1);
        EXPECT_GE(rows.size(), 4u);
        for (const DirectRow& row : rows) {
            EXPECT_EQ(row.differences, 0u) << row.path;
            EXPECT_EQ(row.blocks, 4u) << row.path;
            EXPECT_GT(row.ratio.median, 0) << row.path;
            EXPECT_LE(row.ratio.low, row.ratio.median);
            EXPECT_LE(row.ratio.median, row.ratio.high);
        }
    }
}

TEST(EmbreeDirect, leaves_out_rays_that_embree_cannot_take) {
    std::vector<Ray> rays = camera_rays(32);
    for (Ray& ray : rays) ray.t_min = -1;
    EXPECT_TRUE(measure_direct(bumpy_ball(4), RayKind::camera, rays, 1).empty());
}

}  // namespace
}  // namespace rayshoot::yardsticks
