#include <gtest/gtest.h>

#include "tests/tracer/test_scenes.h"

namespace rayshoot {
namespace {

using tracer_tests::build;
using tracer_tests::render;
using tracer_tests::scaled;
using tracer_tests::small_scene;

RenderSettings settings(int size = 64) {
    RenderSettings result;
    result.format = {size, size, 1, Raster::centres, 0};
    result.threads = 1;
    return result;
}

float largest_difference(const Image& a, const Image& b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        largest = std::max(largest, taxicab(a.pixels()[i] - b.pixels()[i]));
    }
    return largest;
}

std::size_t differing_pixels(const Image& a, const Image& b, float tolerance) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        differing += taxicab(a.pixels()[i] - b.pixels()[i]) > tolerance;
    }
    return differing;
}

TEST(Render, structure_and_threads_leave_the_image_alone) {
    const Scene scene = small_scene();
    RenderSettings one = settings();
    one.format.spp = 3;
    const RenderResult reference = render(scene, "brute_force", one);
    for (const int threads : {1, 2, 4}) {
        RenderSettings many = one;
        many.threads = threads;
        const RenderResult result = render(scene, "bvh", many);
        EXPECT_EQ(result.image, reference.image) << threads;
        EXPECT_EQ(result.counts, reference.counts) << threads;
        EXPECT_EQ(result.session, nullptr);
    }
}

TEST(Render, every_kind_of_ray_is_traced) {
    const RenderResult result = render(small_scene(), "bvh", settings());
    EXPECT_EQ(result.counts[Cause::camera].rays, 64u * 64u);
    for (const RayCount& count : result.counts.by_cause) {
        EXPECT_GT(count.hits, 0u);
        EXPECT_GT(count.rays, count.hits);
    }
}

TEST(Render, counting_agrees_with_the_tracer_and_with_timing) {
    const Scene scene = small_scene();
    RenderSettings counting = settings();
    counting.mode = Mode::counting;
    const RenderResult counted = render(scene, "bvh", counting);
    const RenderResult timed = render(scene, "bvh", settings());
    EXPECT_EQ(counted.image, timed.image);
    EXPECT_EQ(counted.counts, timed.counts);
    ASSERT_NE(counted.session, nullptr);
    for (const RayKind kind : {RayKind::camera, RayKind::shadow, RayKind::secondary}) {
        const Counters* counters = counted.session->counters(kind);
        ASSERT_NE(counters, nullptr);
        EXPECT_EQ((*counters)[Event::ray], counted.counts.of(kind).rays);
        EXPECT_EQ((*counters)[Event::hit], counted.counts.of(kind).hits);
        EXPECT_EQ((*counters)[Event::declined], 0u);
    }
}

TEST(Render, batch_size_changes_no_count) {
    const Scene scene = small_scene();
    const RenderResult reference = render(scene, "bvh", settings());
    for (const std::size_t batch : {std::size_t{1}, std::size_t{7}, max_batch}) {
        RenderSettings other = settings();
        other.batch = batch;
        const RenderResult result = render(scene, "bvh", other);
        EXPECT_EQ(result.counts, reference.counts) << batch;
        EXPECT_LT(largest_difference(result.image, reference.image), 1e-5f) << batch;
    }
}

TEST(Render, a_seed_moves_only_the_jitter) {
    const Scene scene = small_scene();
    RenderSettings other = settings();
    other.format.seed = 17;
    EXPECT_EQ(render(scene, "bvh", other).image, render(scene, "bvh", settings()).image);
    RenderSettings jittered = settings();
    jittered.format.spp = 4;
    RenderSettings jittered_otherwise = jittered;
    jittered_otherwise.format.seed = 17;
    EXPECT_NE(render(scene, "bvh", jittered).image, render(scene, "bvh", jittered_otherwise).image);
}

TEST(Render, scaling_by_a_power_of_two_changes_no_bit) {
    const Scene scene = scaled(small_scene(), 1);
    const RenderResult reference = render(scene, "bvh", settings());
    for (const float factor : {0x1p-20f, 0x1p20f}) {
        const RenderResult result = render(scaled(scene, factor), "bvh", settings());
        EXPECT_EQ(result.image, reference.image) << factor;
    }
}

TEST(Render, scaling_by_a_million_changes_next_to_nothing) {
    const Scene scene = scaled(small_scene(), 1);
    const RenderResult reference = render(scene, "bvh", settings(128));
    for (const float factor : {1e-6f, 1e6f}) {
        const RenderResult result = render(scaled(scene, factor), "bvh", settings(128));
        EXPECT_LT(differing_pixels(result.image, reference.image, 1e-3f), 5u) << factor;
    }
}

TEST(Render, an_empty_scene_is_background) {
    Scene scene;
    scene.geometry = GeometryBuilder().build();
    scene.background = {0.25f, 0.5f, 0.75f};
    const RenderResult result = render(scene, "bvh", settings(8));
    for (const vec3& pixel : result.image.pixels()) EXPECT_EQ(pixel, scene.background);
    EXPECT_EQ(result.counts[Cause::camera].hits, 0u);
}

TEST(Render, depth_bounds_the_ray_tree) {
    RenderSettings flat = settings();
    flat.transport.depth = 1;
    const RenderResult result = render(small_scene(), "bvh", flat);
    EXPECT_EQ(result.counts.of(RayKind::secondary).rays, 0u);
    EXPECT_GT(result.counts.of(RayKind::shadow).rays, 0u);
}

TEST(Render, progress_runs_up_to_the_end) {
    RenderSettings watched = settings(512);
    watched.threads = 2;
    double last = 0;
    watched.progress = [&](double share, double seconds_left) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1);
        EXPECT_GE(seconds_left, 0);
        last = share;
    };
    render(small_scene(), "brute_force", watched);
}

TEST(Render, nonsense_is_refused) {
    const Scene scene = small_scene();
    RenderSettings bad = settings();
    bad.batch = 0;
    EXPECT_THROW(render(scene, "bvh", bad), std::invalid_argument);
    bad.batch = max_batch + 1;
    EXPECT_THROW(render(scene, "bvh", bad), std::invalid_argument);
    bad = settings();
    bad.transport.depth = -1;
    EXPECT_THROW(render(scene, "bvh", bad), std::invalid_argument);
    bad = settings();
    bad.threads = -1;
    EXPECT_THROW(render(scene, "bvh", bad), std::invalid_argument);
    Scene soft = small_scene();
    soft.lights[0].kind = LightKind::rectangle;
    EXPECT_THROW(render(soft, "bvh", settings()), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
