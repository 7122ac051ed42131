#include "tracer/shutter.h"

#include "accel/core/catalogue.h"
#include "tracer/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace rayshoot {
namespace {

struct Weight {
    ShutterWeight kind;
    std::function<double(double)> density;  ///< of times in [0, 1]
};

const std::vector<Weight>& weights() {
    static const std::vector<Weight> all{
        {ShutterWeight::box, [](double) { return 1.0; }},
        {ShutterWeight::triangle, [](double t) { return 4 * std::min(t, 1 - t); }},
        {ShutterWeight::raised_cosine,
         [](double t) { return 1 - std::cos(2 * std::numbers::pi * t); }}};
    return all;
}

/// Integral of the density from 0 to t by Simpson's rule; the triangle's kink is a node.
double integral(const Weight& weight, double t) {
    constexpr int steps = 2000;
    const auto piece = [&](double from, double to) {
        const double h = (to - from) / steps;
        double sum = weight.density(from) + weight.density(to);
        for (int i = 1; i < steps; ++i) sum += (i % 2 ? 4 : 2) * weight.density(from + i * h);
        return sum * h / 3;
    };
    return t < 0.5 ? piece(0, t) : piece(0, 0.5) + piece(0.5, t);
}

TEST(Shutter, distribution_is_the_integral_of_its_weight) {
    for (const Weight& weight : weights())
        for (int i = 0; i <= 50; ++i) {
            const double t = i / 50.0;
            EXPECT_NEAR((Shutter{0, 1, weight.kind}.distribution(t)), integral(weight, t), 1e-12)
                << name(weight.kind);
        }
}

TEST(Shutter, time_inverts_the_distribution_to_rounding) {
    for (const Weight& weight : weights())
        for (const Shutter& shutter : {Shutter{0, 1, weight.kind}, {0.25f, 0.5f, weight.kind}}) {
            float last = shutter.open;
            for (int i = 0; i <= 4096; ++i) {
                const float u = static_cast<float>(i) / 4096, time = shutter.time(u);
                EXPECT_GE(time, last);
                EXPECT_LE(time, shutter.close);
                // A rounded time is off by 2^-25; the density is at most 2 / (close - open).
                EXPECT_NEAR(shutter.distribution(time), u, 4e-7);
                last = time;
            }
            EXPECT_EQ(shutter.time(0), shutter.open);
            EXPECT_EQ(shutter.time(1), shutter.close);
        }
}

TEST(Shutter, that_is_open_for_an_instant_has_one_time) {
    for (const Weight& weight : weights())
        for (const float u : {0.0f, 0.3f, 0.999f})
            EXPECT_EQ((Shutter{0.5f, 0.5f, weight.kind}.time(u)), 0.5f);
}

TEST(Shutter, is_named_and_checked) {
    for (const Weight& weight : weights())
        EXPECT_EQ(shutter_weight(name(weight.kind)), weight.kind);
    EXPECT_THROW(shutter_weight("hat"), std::invalid_argument);
    EXPECT_NO_THROW(require_valid(Shutter{}));
    for (const Shutter& wrong :
         {Shutter{0.5f, 0.4f}, Shutter{-0.1f, 1}, Shutter{0, 1.5f}, Shutter{std::nanf(""), 1}})
        EXPECT_THROW(require_valid(wrong), std::invalid_argument);
}

/// A plate whose right edge moves from x = -1 to x = 1 while the shutter is open, before a camera
/// that sees x in [-2, 2] as 64 cells.
struct MovingEdge {
    Scene scene;
    MovingEdge() {
        GeometryBuilder builder;
        const std::uint32_t motion =
            builder.add_motion({.translation = {vec3(-1, 0, 0), vec3(1, 0, 0)}});
        const std::array<vec3, 4> plate{vec3(-9, -3, 0), vec3(0, -3, 0), vec3(0, 3, 0),
                                        vec3(-9, 3, 0)};
        builder.add_polygon(plate, {}, motion);
        scene.geometry = std::move(builder).build();
        scene.camera.from = {0, 0, 2};
        scene.camera.angle = 90;
    }
};

TEST(Shutter, a_moving_edge_has_the_profile_of_its_integral) {
    constexpr int cells = 64, moments = 1024;
    const MovingEdge edge;
    const ImageFormat format{cells, cells, 1, Raster::centres, 0};
    const CameraRays camera(edge.scene.camera, format);
    const auto accel = build(built_in_catalogue(), "brute_force", build_input(edge.scene, format));
    const auto session = accel->open(Mode::timing);
    for (const Weight& weight : weights()) {
        const Shutter shutter{0, 1, weight.kind};
        for (int cell = 0; cell < cells; ++cell) {
            std::vector<Ray> rays;
            for (int i = 0; i < moments; ++i)
                rays.push_back(camera.ray(cell + 0.5, cells / 2, {},
                                          shutter.time((static_cast<float>(i) + 0.5f) / moments)));
            std::vector<std::uint8_t> hit(rays.size());
            session->occluded({.rays = rays}, hit);
            const double covered = static_cast<double>(std::ranges::count(hit, 1)) / moments;
            const double x = (cell + 0.5) / cells * 4 - 2;
            // Covered from the moment on that the edge has passed x.
            const double wanted = 1 - integral(weight, std::clamp((x + 1) / 2, 0.0, 1.0));
            EXPECT_NEAR(covered, wanted, 1.0 / moments) << name(weight.kind) << " at " << x;
        }
    }
}

}  // namespace
}  // namespace rayshoot
