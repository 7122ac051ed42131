#include <gtest/gtest.h>

#include <algorithm>

#include "accel/core/promise.h"
#include "tests/tracer/test_scenes.h"
#include "tracer/recorder.h"

namespace rayshoot {
namespace {

using tracer_tests::build;
using tracer_tests::small_scene;

constexpr ImageFormat format{48, 32, 2, Raster::centres, 11};

RecordedStreams recorded(const Scene& scene, const std::string& spec) {
    return record_streams(scene, *build(scene, spec, format), format);
}

bool equal(const RecordedRays& a, const RecordedRays& b) {
    const auto same_ray = [](const Ray& x, const Ray& y) {
        return x.origin == y.origin && x.direction == y.direction && x.t_min == y.t_min &&
               x.t_max == y.t_max && x.time == y.time;
    };
    const auto same_source = [](Source x, Source y) { return x.bits == y.bits; };
    return std::ranges::equal(a.rays, b.rays, same_ray) &&
           std::ranges::equal(a.sources, b.sources, same_source);
}

TEST(Recorder, streams_are_those_of_a_render) {
    const Scene scene = small_scene();
    const RecordedStreams streams = recorded(scene, "bvh");
    RenderSettings settings;
    settings.format = format;
    settings.transport.depth = 2;
    const RayCounts counts = tracer_tests::render(scene, "bvh", settings).counts;
    EXPECT_EQ(streams.camera.rays.size(), counts.of(RayKind::camera).rays);
    EXPECT_EQ(streams.secondary.rays.size(), counts.of(RayKind::secondary).rays);
    EXPECT_EQ(streams.diffuse.rays.size(), counts.of(RayKind::camera).hits);
    EXPECT_EQ(streams.random.rays.size(), counts.of(RayKind::camera).rays);
    settings.transport.depth = 1;
    const RayCounts flat = tracer_tests::render(scene, "bvh", settings).counts;
    EXPECT_EQ(streams.shadow.rays.size(), flat.of(RayKind::shadow).rays);
}

TEST(Recorder, structure_does_not_show_in_the_rays) {
    const Scene scene = small_scene();
    const RecordedStreams a = recorded(scene, "bvh"), b = recorded(scene, "brute_force");
    EXPECT_TRUE(equal(a.camera, b.camera));
    EXPECT_TRUE(equal(a.shadow, b.shadow));
    EXPECT_TRUE(equal(a.secondary, b.secondary));
    EXPECT_TRUE(equal(a.diffuse, b.diffuse));
    EXPECT_TRUE(equal(a.random, b.random));
}

TEST(Recorder, sources_tell_the_truth) {
    const Scene scene = small_scene();
    const RecordedStreams streams = recorded(scene, "bvh");
    const BuildInput input = build_input(scene, format);
    ASSERT_EQ(streams.camera.sources.size(), streams.camera.rays.size());
    ASSERT_EQ(streams.shadow.sources.size(), streams.shadow.rays.size());
    EXPECT_EQ(
        broken_promise(input, {RayKind::camera, 1, streams.camera.rays, streams.camera.sources}),
        "");
    EXPECT_EQ(
        broken_promise(input, {RayKind::shadow, 1, streams.shadow.rays, streams.shadow.sources}),
        "");
}

/// Null hypothesis: bounces off the floor follow the cosine. Then cos^2 is uniform: mean 1/2,
/// variance 1/12; the level is 4 standard deviations (1 in 16,000).
TEST(Recorder, diffuse_bounces_follow_the_cosine) {
    Scene scene = small_scene();
    GeometryBuilder builder;
    builder.add_triangle({-900, -900, 0}, {900, -900, 0}, {0, 900, 0});
    scene.geometry = std::move(builder).build();
    scene.camera.from = {0, 0, 10};
    scene.camera.up = {0, 1, 0};
    const RecordedStreams streams = recorded(scene, "bvh");
    ASSERT_GT(streams.diffuse.rays.size(), 3000u);
    double sum = 0, sideways = 0;
    for (const Ray& ray : streams.diffuse.rays) {
        ASSERT_GT(ray.origin.z, 0);
        ASSERT_NEAR(length(ray.direction), 1, 1e-6f);
        sum += double{ray.direction.z} * ray.direction.z;
        sideways += ray.direction.x;
    }
    const double count = static_cast<double>(streams.diffuse.rays.size());
    EXPECT_NEAR(sum / count, 0.5, 4 * std::sqrt(1 / (12 * count)));
    EXPECT_NEAR(sideways / count, 0, 4 * std::sqrt(1 / (4 * count)));  // E x^2 = 1/4
}

TEST(Recorder, chords_start_on_the_sphere_round_the_scene) {
    const Scene scene = small_scene();
    const Box& bounds = scene.geometry.bounds();
    const float radius = 0.5f * length(bounds.size());
    for (const Ray& ray : recorded(scene, "bvh").random.rays) {
        EXPECT_NEAR(length(ray.origin - bounds.centre()), radius, 1e-5f * radius);
        EXPECT_NEAR(length(ray.origin + ray.direction - bounds.centre()), radius, 1e-5f * radius);
    }
}

TEST(Recorder, chords_alone_are_those_of_the_streams) {
    const Scene scene = small_scene();
    const RecordedRays recorded_rays = recorded(scene, "bvh").random;
    const std::vector<Ray> rays =
        random_chords(scene.geometry.bounds(), recorded_rays.rays.size(), format.seed);
    EXPECT_TRUE(equal({rays, {}}, recorded_rays));
    EXPECT_TRUE(random_chords(Box{}, 10).empty());
}

TEST(Recorder, an_empty_scene_gives_camera_rays_only) {
    Scene scene;
    scene.geometry = GeometryBuilder().build();
    const RecordedStreams streams = recorded(scene, "bvh");
    EXPECT_EQ(streams.camera.rays.size(), 48u * 32u * 2u);
    EXPECT_TRUE(streams.shadow.rays.empty() && streams.secondary.rays.empty() &&
                streams.diffuse.rays.empty() && streams.random.rays.empty());
}

}  // namespace
}  // namespace rayshoot
