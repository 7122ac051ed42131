#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tracer/camera.h"
#include "tracer/tiles.h"

namespace rayshoot {
namespace {

/// Looks down -z with y up, 90 degrees: slopes at the image's edge are 1.
Camera square_camera() {
    Camera camera;
    camera.from = {0, 0, 4};
    camera.at = {0, 0, 0};
    camera.up = {0, 1, 0};
    camera.angle = 90;
    return camera;
}

vec3 slope(const Ray& ray) { return ray.direction / -ray.direction.z; }

void expect_slope(const Ray& ray, float x, float y) {
    EXPECT_NEAR(slope(ray).x, x, 1e-6f);
    EXPECT_NEAR(slope(ray).y, y, 1e-6f);
}

TEST(Camera, corner_rays_span_the_whole_angle) {
    const CameraRays rays(square_camera(), spd_format);
    expect_slope(rays.ray({0, 0}, 0), -1, 1);
    expect_slope(rays.ray({512, 0}, 0), 1, 1);
    expect_slope(rays.ray({0, 512}, 0), -1, -1);
    expect_slope(rays.ray({256, 256}, 0), 0, 0);
    expect_slope(rays.ray({1, 3}, 0), 2.0f / 512 - 1, 1 - 6.0f / 512);
}

TEST(Camera, centre_rays_go_through_the_middle_of_pixels) {
    const CameraRays rays(square_camera(), {4, 2, 1, Raster::centres, 0});
    expect_slope(rays.ray({0, 0}, 0), -1.5f, 0.5f);
    expect_slope(rays.ray({3, 1}, 0), 1.5f, -0.5f);
}

TEST(Camera, view_is_orthonormal_and_right_handed) {
    Camera camera = square_camera();
    camera.from = {1, 2, 3};
    camera.up = {0.3f, 1, 0.2f};
    const View view = make_view(camera, mesh_format);
    EXPECT_NEAR(dot(view.right, view.up), 0, 1e-6f);
    EXPECT_NEAR(dot(view.right, view.forward), 0, 1e-6f);
    EXPECT_NEAR(length(view.right), 1, 1e-6f);
    EXPECT_NEAR(dot(cross(view.right, view.up), -view.forward), 1, 1e-6f);
}

/// As the structures read it: View::direction at the ray's raster point.
TEST(Camera, rays_go_through_the_cell_that_they_promise) {
    for (const Raster raster : {Raster::corners, Raster::centres}) {
        const ImageFormat format{33, 21, 6, raster, 5};
        const CameraRays rays(square_camera(), format);
        const View& view = rays.view();
        for (const Pixel pixel : morton_order(format.width, format.height)) {
            for (int sample = 0; sample < format.spp; ++sample) {
                const Ray ray = rays.ray(pixel, sample);
                const vec3 in_raster = ray.direction - view.to_corner;
                const float x = dot(in_raster, view.across) / dot(view.across, view.across);
                const float y = dot(in_raster, view.down) / dot(view.down, view.down);
                EXPECT_GE(x, static_cast<float>(pixel.x) - 1e-4f);
                EXPECT_LE(x, static_cast<float>(pixel.x) + 1 + 1e-4f);
                EXPECT_GE(y, static_cast<float>(pixel.y) - 1e-4f);
                EXPECT_LE(y, static_cast<float>(pixel.y) + 1 + 1e-4f);
                EXPECT_EQ(CameraRays::source(pixel).cell_x(), pixel.x);
                EXPECT_EQ(CameraRays::source(pixel).cell_y(), pixel.y);
            }
        }
    }
}

TEST(Camera, samples_of_a_cell_fall_one_into_each_stratum) {
    const ImageFormat format{1, 1, 12, Raster::centres, 3};  // 4 x 3 strata
    const CameraRays rays(square_camera(), format);
    std::set<std::pair<int, int>> strata;
    for (int sample = 0; sample < format.spp; ++sample) {
        const vec3 at = slope(rays.ray({0, 0}, sample));
        strata.insert({static_cast<int>((at.x + 1) / 2 * 4), static_cast<int>((1 - at.y) / 2 * 3)});
    }
    EXPECT_EQ(strata.size(), 12u);
}

TEST(Camera, nonsense_is_refused) {
    Camera nowhere = square_camera();
    nowhere.at = nowhere.from;
    EXPECT_THROW(make_view(nowhere, spd_format), std::invalid_argument);
    Camera upwards = square_camera();
    upwards.up = {0, 0, 2};
    EXPECT_THROW(make_view(upwards, spd_format), std::invalid_argument);
    for (const float angle : {0.0f, 180.0f, -3.0f, std::nanf("")}) {
        Camera wide = square_camera();
        wide.angle = angle;
        EXPECT_THROW(make_view(wide, spd_format), std::invalid_argument);
    }
    EXPECT_THROW(make_view(square_camera(), {0, 1, 1}), std::invalid_argument);
    EXPECT_THROW(make_view(square_camera(), {1, 40000, 1}), std::invalid_argument);
    EXPECT_THROW(make_view(square_camera(), {1, 1, 0}), std::invalid_argument);
}

/// Bits of x at even and of y at odd places.
std::uint32_t morton_code(Pixel pixel) {
    std::uint32_t code = 0;
    for (int bit = 0; bit < 15; ++bit) {
        code |= (static_cast<std::uint32_t>(pixel.x >> bit) & 1u) << (2 * bit);
        code |= (static_cast<std::uint32_t>(pixel.y >> bit) & 1u) << (2 * bit + 1);
    }
    return code;
}

TEST(Tiles, hold_every_pixel_once_in_morton_order) {
    for (const auto& [width, height] : {std::pair{1, 1}, {513, 7}, {5, 64}, {33, 33}}) {
        const std::vector<Pixel> order = morton_order(width, height);
        ASSERT_EQ(order.size(), static_cast<std::size_t>(width * height));
        for (std::size_t i = 1; i < order.size(); ++i) {
            ASSERT_LT(morton_code(order[i - 1]), morton_code(order[i]));
        }
    }
}

TEST(Tiles, fill_a_batch_with_whole_pixels) {
    const Tiles tiles({64, 64, 3, Raster::centres, 0}, 1024);
    ASSERT_EQ(tiles.size(), 13u);  // 341 pixels a tile
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        EXPECT_LE(tiles.tile(i).size() * 3, 1024u);
        pixels += tiles.tile(i).size();
    }
    EXPECT_EQ(pixels, 64u * 64u);
    EXPECT_EQ(Tiles({8, 8, 5000, Raster::centres, 0}, 1024).size(), 64u);
}

}  // namespace
}  // namespace rayshoot
