#include <gtest/gtest.h>

#include "tests/tracer/spd_scenes.h"

/// Havran & Sixta 1999, uniform grids of the SPD scenes tetra and balls: what the cells hold is
/// exact for tetra and nearly so for balls, what rays do in them is close.
namespace rayshoot {
namespace {

struct Published {
    const char *scene, *resolution;
    std::uint64_t cells, empty_cells, references;             ///< N_V, N_EV, N_OIV
    double object_tests, cells_per_ray, empty_cells_per_ray;  ///< N_IT, N_ETS, N_EETS
};

class HavranGrid : public testing::TestWithParam<Published> {
protected:
    HavranGrid() {
        settings_.format = spd_format;
        settings_.transport.rules = Rules::havran;
        settings_.mode = Mode::counting;
        accel_ = tracer_tests::build(scene_,
                                     std::string("grid:resolution=") + GetParam().resolution +
                                         ",overlap=havran,leaves=single,skip=none",
                                     spd_format);
    }

    Scene scene_ = tracer_tests::spd_scene(GetParam().scene);
    RenderSettings settings_;
    std::unique_ptr<Accel> accel_;
};

TEST_P(HavranGrid, holds_what_is_published) {
    const Footprint made = accel_->footprint();
    const bool exact = std::string_view(GetParam().scene) == "tetra";
    EXPECT_EQ(*made.leaves, GetParam().cells);
    EXPECT_NEAR(double(*made.empty_leaves), double(GetParam().empty_cells), exact ? 0 : 3);
    EXPECT_NEAR(double(*made.references), double(GetParam().references),
                exact ? 0 : 0.002 * double(GetParam().references));
}

TEST_P(HavranGrid, is_walked_as_is_published) {
    const RenderResult result = render(scene_, *accel_, settings_);
    Counters sum;
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::secondary})
        sum += *result.session->counters(kind);
    const auto per_ray = [&](Event event) { return double(sum[event]) / double(sum[Event::ray]); };
    const auto close = [](double ours, double theirs, double share) {
        EXPECT_NEAR(ours, theirs, share * theirs);
    };
    close(per_ray(Event::object_test), GetParam().object_tests, 0.06);
    close(per_ray(Event::cell), GetParam().cells_per_ray, 0.02);
    close(per_ray(Event::empty_cell), GetParam().empty_cells_per_ray, 0.02);
    EXPECT_EQ(sum[Event::step], sum[Event::cell]);
}

INSTANTIATE_TEST_SUITE_P(
    Spd, HavranGrid,
    testing::Values(Published{"tetra", "16x16x16", 4096, 3104, 12556, 20.64, 7.43, 5.83},
                    Published{"tetra", "35x35x35", 42875, 37311, 35936, 10.01, 15.97, 14.36},
                    Published{"tetra", "40x40x40", 64000, 56696, 44696, 9.17, 18.24, 16.63},
                    Published{"balls", "103x103x7", 74263, 63393, 19966, 72.54, 12.40, 9.27},
                    Published{"balls", "152x152x9", 207936, 184204, 33909, 41.48, 17.32, 13.93}),
    [](const auto& of) { return std::string(of.param.scene) + "_" + of.param.resolution; });

}  // namespace
}  // namespace rayshoot
