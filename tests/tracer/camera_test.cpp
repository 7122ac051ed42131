#include <gtest/gtest.h>

#include <cmath>

#include "accel/core/catalogue.h"
#include "accel/core/promise.h"
#include "tests/core/motions.h"
#include "tracer/camera.h"
#include "tracer/sampling/sampler.h"
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
    expect_slope(rays.ray({0, 0}), -1, 1);
    expect_slope(rays.ray({512, 0}), 1, 1);
    expect_slope(rays.ray({0, 512}), -1, -1);
    expect_slope(rays.ray({256, 256}), 0, 0);
    expect_slope(rays.ray({1, 3}), 2.0f / 512 - 1, 1 - 6.0f / 512);
}

TEST(Camera, centre_rays_go_through_the_middle_of_pixels) {
    const CameraRays rays(square_camera(), {4, 2, 1, Raster::centres, 0});
    expect_slope(rays.ray({0, 0}), -1.5f, 0.5f);
    expect_slope(rays.ray({3, 1}), 1.5f, -0.5f);
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
        const Sampler sampler({.spp = format.spp, .seed = format.seed});
        for (const Pixel pixel : morton_order(format.width, format.height)) {
            for (std::uint32_t sample = 0; sample < 6; ++sample) {
                const Pair at = sampler.pair(pixel, sample, {Use::pixel});
                const Ray ray = rays.ray(pixel.x + double{at.u}, pixel.y + double{at.v}, {}, 0);
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

TEST(Camera, a_raster_point_without_lens_or_motion_is_the_pixels_ray) {
    const CameraRays rays(square_camera(), {31, 17, 1, Raster::centres, 0});
    for (const Pixel pixel : morton_order(31, 17)) {
        const Ray ray = rays.ray(pixel.x + 0.5, pixel.y + 0.5, {0.1f, 0.8f}, 0.75f);
        EXPECT_EQ(ray.direction, rays.ray(pixel).direction);
        EXPECT_EQ(ray.origin, rays.ray(pixel).origin);
        EXPECT_EQ(ray.time, 0.75f);
        EXPECT_EQ(CameraRays::cell(pixel.x + 0.5, pixel.y + 0.999), pixel);
    }
    EXPECT_EQ(CameraRays::cell(-0.5, -1), (Pixel{-1, -1}));
}

/// A camera of every kind: with and without a lens, still and moving, near and far from the
/// coordinates' origin.
std::vector<Camera> cameras_of_all_kinds() {
    std::vector<Camera> cameras;
    cases::Random random(31);
    for (const float distance : {0.0f, 10.0f, 1e4f})
        for (int kind = 0; kind < 4; ++kind) {
            Camera camera = square_camera();
            camera.from += vec3(distance, -distance, 2 * distance);
            camera.at += vec3(distance, -distance, 2 * distance);
            camera.up = {0.3f, 1, 0.2f};
            if (kind & 1) camera.lens = Lens{0.2f, 0.8f, 3, kind & 2 ? 0 : 5, 10};
            if (kind & 2) {
                camera.motion = cases::motion(random);
                camera.motion->pivot += camera.from;
            }
            cameras.push_back(camera);
        }
    return cameras;
}

struct Asked {
    std::vector<Ray> rays;
    std::vector<Source> sources;
};

/// Random places in and round the image, random points of the lens, random times.
Asked random_rays(const CameraRays& rays, cases::Random& random) {
    Asked asked;
    const View& view = rays.view();
    for (int i = 0; i < 2000; ++i) {
        const double x = random.uniform(-view.border, view.width + view.border);
        const double y = random.uniform(-view.border, view.height + view.border);
        const Pair lens{static_cast<float>(random.uniform(0, 1)),
                        static_cast<float>(random.uniform(0, 1))};
        asked.rays.push_back(rays.ray(x, y, lens, static_cast<float>(random.uniform(0, 1))));
        asked.sources.push_back(CameraRays::source(x, y));
    }
    return asked;
}

TEST(Camera, rays_keep_their_promise_with_lens_motion_and_border) {
    cases::Random random(32);
    for (const Camera& camera : cameras_of_all_kinds())
        for (const int border : {0, 3}) {
            Scene scene;
            scene.camera = camera;
            const ImageFormat format{97, 61, 1, Raster::centres, 0};
            const BuildInput input = build_input(scene, format, border);
            EXPECT_EQ(input.view->border, border);
            Asked asked = random_rays(CameraRays(camera, format, border), random);
            const RayBatch batch{RayKind::camera, 1, asked.rays, asked.sources};
            EXPECT_EQ(broken_promise(input, batch), "");
        }
}

TEST(Camera, a_broken_promise_of_cell_lens_or_border_is_seen) {
    cases::Random random(33);
    for (const Camera& camera : cameras_of_all_kinds()) {
        Scene scene;
        scene.camera = camera;
        const ImageFormat format{97, 61, 1, Raster::centres, 0};
        const BuildInput input = build_input(scene, format, 2);
        const Asked asked = random_rays(CameraRays(camera, format, 2), random);
        const auto complaint = [&](const Ray& ray, Source source) {
            return broken_promise(input, {RayKind::camera, 1, {&ray, 1}, {&source, 1}});
        };
        for (std::size_t i = 0; i < 200; ++i) {
            const auto [x, y] = std::pair(asked.sources[i].cell_x(), asked.sources[i].cell_y());
            const auto next = static_cast<std::int16_t>(x > 40 ? x - 2 : x + 2);
            EXPECT_NE(complaint(asked.rays[i], Source::cell(next, y)), "");
            EXPECT_NE(complaint(asked.rays[i], Source::cell(-3, y)), "");
            EXPECT_NE(complaint(asked.rays[i], Source::cell(x, 63)), "");
            Ray beside = asked.rays[i];
            beside.origin += 1.0f * normalised(cross(beside.direction, vec3(0, 1, 0.1f)));
            EXPECT_NE(complaint(beside, asked.sources[i]), "");
        }
    }
}

/// Spheres round the origin, seen from (0, 0, 4).
Scene spheres(const Motion& motion) {
    GeometryBuilder builder;
    const std::uint32_t moves = builder.add_motion(motion);
    cases::Random random(34);
    for (int i = 0; i < 60; ++i) builder.add_sphere({random.in_cube(2), 0.3f}, moves);
    Scene scene;
    scene.geometry = std::move(builder).build();
    scene.camera = square_camera();
    return scene;
}

/// The hits of a moving camera on a scene at rest, and of a camera at rest on a moving scene.
void expect_same_hits(const Motion& of_camera, const Motion& of_scene) {
    const ImageFormat format{40, 40, 1, Raster::centres, 0};
    Scene still = spheres(Motion{});
    still.camera.motion = of_camera;
    const Scene moving = spheres(of_scene);
    const auto hits = [&](const Scene& scene) {
        const auto accel = build(built_in_catalogue(), "brute_force", build_input(scene, format));
        const CameraRays camera(scene.camera, format);
        std::vector<Ray> rays;
        for (int i = 0; i < 1600; ++i)
            rays.push_back(
                camera.ray(i % 40 + 0.5, i / 40 + 0.5, {}, 0.1f * static_cast<float>(i * 7 % 11)));
        std::vector<Hit> found(rays.size());
        accel->open(Mode::timing)->closest({.rays = rays}, found);
        return found;
    };
    const std::vector<Hit> one = hits(still), other = hits(moving);
    int same = 0, met = 0;
    for (std::size_t i = 0; i < one.size(); ++i) {
        met += one[i].primitive != no_primitive;
        if (one[i].primitive != other[i].primitive) continue;  // grazed: counted below
        ++same;
        if (one[i].primitive == no_primitive) continue;
        EXPECT_NEAR(one[i].t, other[i].t, 2e-3f);
    }
    EXPECT_GT(met, 300);
    EXPECT_GE(same, 1598);  // of 1600
}

TEST(Camera, pans_as_the_scene_moves_the_other_way) {
    const vec3 from(0.2f, -0.1f, 0.3f), to(-0.5f, 0.4f, 0.1f);
    expect_same_hits({.translation = {from, to}}, {.translation = {-from, -to}});
}

TEST(Camera, turns_as_the_scene_turns_the_other_way) {
    constexpr float s = 0.25881905f, c = 0.96592583f;  // 15 degrees: a turn by 30 about y
    const vec3 pivot(0.5f, 0, 1);
    const Motion::Quaternion none{0, 0, 0, 1};
    expect_same_hits({.pivot = pivot, .rotation = {none, Motion::Quaternion{0, s, 0, c}}},
                     {.pivot = pivot, .rotation = {none, Motion::Quaternion{0, -s, 0, c}}});
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
    Camera bent = square_camera();
    bent.motion = Motion{.rotation = {Motion::Quaternion{0, 0, 0, 2}, {0, 0, 0, 1}}};
    EXPECT_THROW(make_view(bent, spd_format), std::invalid_argument);
    EXPECT_THROW(make_view(square_camera(), spd_format, -1), std::invalid_argument);
    EXPECT_THROW(make_view(square_camera(), {1, 32000, 1}, 1000), std::invalid_argument);
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
