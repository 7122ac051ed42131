#include "tracer/lens.h"

#include "tracer/camera.h"
#include "tracer/sampling/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace rayshoot {
namespace {

constexpr float focus = 4;
constexpr int side = 40;  // lens pairs along an axis

/// At the origin, looking down -z with y up; 60 degrees high.
Camera camera_with(const Lens& lens) {
    Camera camera;
    camera.from = {0, 0, 0};
    camera.at = {0, 0, -1};
    camera.angle = 60;
    camera.lens = lens;
    return camera;
}

constexpr Lens wide_open{.focal_length = 0.5f, .f_stop = 1.25f, .focus_distance = focus};
const ImageFormat format{400, 300, 1, Raster::centres, 0};

/// Stratum centres over the unit square.
std::vector<Pair> lattice() {
    std::vector<Pair> pairs;
    for (int i = 0; i < side * side; ++i)
        pairs.push_back({(static_cast<float>(i % side) + 0.5f) / side,
                         (static_cast<float>(i / side) + 0.5f) / side});
    return pairs;
}

struct Place {
    double x, y;
};

Place at_depth(const Ray& ray, double depth) {
    const double t = depth / -double{ray.direction.z};
    return {ray.origin.x + t * ray.direction.x, ray.origin.y + t * ray.direction.y};
}

/// The raster point whose ray from this lens point goes through (x, y, -depth): raster points map
/// to points of that plane affinely, so three rays tell.
Place image_of(const CameraRays& rays, Pair lens, const Place& point, double depth) {
    constexpr double step = 100;  // cells
    const Place o = at_depth(rays.ray(0, 0, lens, 0), depth);
    const Place x = at_depth(rays.ray(step, 0, lens, 0), depth);
    const Place y = at_depth(rays.ray(0, step, lens, 0), depth);
    const double ax = (x.x - o.x) / step, ay = (x.y - o.y) / step;
    const double bx = (y.x - o.x) / step, by = (y.y - o.y) / step;
    const double determinant = ax * by - ay * bx;
    const double dx = point.x - o.x, dy = point.y - o.y;
    return {(dx * by - dy * bx) / determinant, (ax * dy - ay * dx) / determinant};
}

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

double on_unit_disc(Pair pair) {
    const auto on = concentric_disc(pair);
    return std::hypot(on.x, on.y);
}

TEST(Lens, keeps_the_thin_lens_formula) {
    const double object = wide_open.focus_distance, image = image_distance(wide_open);
    EXPECT_NEAR(1 / object + 1 / image, 1 / double{wide_open.focal_length}, 1e-14);
    EXPECT_DOUBLE_EQ(lens_radius(wide_open), 0.2);
}

/// Against the formula as optics books have it: |z - s_o| / z f^2 / (N (s_o - f)).
TEST(Lens, blurs_points_to_the_circle_of_confusion) {
    const CameraRays rays(camera_with(wide_open), format);
    const double f = wide_open.focal_length, stop = wide_open.f_stop;
    const double image_height = 2 * image_distance(wide_open) * std::tan(std::numbers::pi / 6);
    for (const double depth : {1.0, 2.0, 3.9, 4.2, 8.0, 100.0}) {
        const double circle =
            std::abs(depth - focus) / depth * f * f / (stop * (focus - f));  // diameter
        EXPECT_NEAR(circle_of_confusion(wide_open, depth), circle, 1e-12 + 1e-6 * circle);
        const double cells = circle / image_height * format.height;
        const Place point{0.2 * depth, -0.1 * depth};
        const Place middle = image_of(rays, {0.5f, 0.5f}, point, depth);
        double largest = 0;
        for (const Pair pair : lattice()) {
            const Place image = image_of(rays, pair, point, depth);
            const double share = on_unit_disc(pair);
            EXPECT_NEAR(distance(image, middle), cells / 2 * share, 1e-3 + 1e-3 * cells);
            largest = std::max(largest, distance(image, middle));
        }
        EXPECT_GT(largest, 0.96 * cells / 2);  // the lattice reaches 1 - 1 / side of the radius
        EXPECT_LT(largest, cells / 2 + 1e-3);
    }
}

TEST(Lens, leaves_points_in_focus_points) {
    const CameraRays rays(camera_with(wide_open), format);
    for (const Place raster : {Place{0.5, 0.5}, Place{211.25, 7}, Place{400, 300}}) {
        const Ray middle = rays.ray(raster.x, raster.y, {0.5f, 0.5f}, 0);
        const vec3 in_focus = along(middle.origin, focus, middle.direction);
        EXPECT_FLOAT_EQ(in_focus.z, -focus);
        for (const Pair pair : lattice()) {
            const Ray ray = rays.ray(raster.x, raster.y, pair, 0);
            const vec3 met = along(ray.origin, focus, ray.direction);
            EXPECT_LT(length(met - in_focus), 4e-6f);
        }
    }
}

/// By the half-planes of its edges; corners where `blade_angle` says.
TEST(Lens, with_blades_is_a_polygon) {
    for (const int blades : {3, 5, 6, 8}) {
        Lens lens = wide_open;
        lens.blades = blades;
        lens.blade_angle = 17;
        const CameraRays rays(camera_with(lens), format);
        const double radius = lens_radius(lens), turn = 2 * std::numbers::pi / blades;
        const double first = 17 * std::numbers::pi / 180;
        std::vector<double> nearest(static_cast<std::size_t>(blades), radius);
        for (const Pair pair : lattice()) {
            const vec3 on = rays.ray(200, 150, pair, 0).origin;
            EXPECT_EQ(on.z, 0);
            for (int i = 0; i < blades; ++i) {
                const double corner = first + i * turn, edge = corner + turn / 2;
                EXPECT_LE(on.x * std::cos(edge) + on.y * std::sin(edge),
                          radius * std::cos(turn / 2) * (1 + 1e-6));
                double& gap = nearest[static_cast<std::size_t>(i)];
                gap = std::min(gap, distance({on.x, on.y}, {radius * std::cos(corner),
                                                            radius * std::sin(corner)}));
            }
        }
        for (const double gap : nearest) EXPECT_LT(gap, 0.15 * radius) << blades;
    }
}

TEST(Lens, of_an_f_number_alone_is_focused_on_what_the_camera_looks_at) {
    Camera camera;
    camera.from = {0, 0, 10};
    camera.at = {0, 0, 2};
    const Lens lens = lens_for(camera, 2.8f);
    EXPECT_FLOAT_EQ(lens.focus_distance, 8);
    EXPECT_FLOAT_EQ(lens.focal_length, 0.2f);
    EXPECT_NO_THROW(require_valid(lens));
}

TEST(Lens, that_is_none_is_refused) {
    const auto refused = [](auto&& change) {
        Lens lens = wide_open;
        change(lens);
        EXPECT_THROW(require_valid(lens), std::invalid_argument);
        EXPECT_THROW(make_view(camera_with(lens), format), std::invalid_argument);
    };
    refused([](Lens& lens) { lens.focal_length = 0; });
    refused([](Lens& lens) { lens.focal_length = focus; });
    refused([](Lens& lens) { lens.f_stop = -1; });
    refused([](Lens& lens) { lens.focus_distance = std::nanf(""); });
    refused([](Lens& lens) { lens.focus_distance = infinity; });
    refused([](Lens& lens) { lens.blades = 2; });
    refused([](Lens& lens) { lens.blades = -3; });
    refused([](Lens& lens) { lens.blade_angle = infinity; });
}

}  // namespace
}  // namespace rayshoot
