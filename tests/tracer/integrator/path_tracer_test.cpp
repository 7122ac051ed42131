#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "data/nff.h"
#include "tests/tracer/test_scenes.h"

namespace rayshoot {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

const std::string eye = "v from 0 0 0 at 0 0 -1 up 0 1 0 angle 40 hither 0 resolution 8 8\n";

Scene scene_of(const std::string& text) { return read_nff(eye + text, "test.nff"); }

RenderSettings paths(int spp, int size = 8) {
    RenderSettings settings;
    settings.format = {size, size, spp, Raster::centres, 0};
    settings.transport.method = Method::path;
    settings.transport.depth = 255;
    settings.threads = 1;
    return settings;
}

struct Mean {
    double value = 0, error = 0;  ///< standard error of the mean
};

/// Of the red channel of all pixels, which are alike in what they should show.
Mean mean_of(const Image& image) {
    double sum = 0, squares = 0;
    for (const vec3& pixel : image.pixels()) sum += pixel.x;
    const auto count = static_cast<double>(image.pixels().size());
    const double mean = sum / count;
    for (const vec3& pixel : image.pixels()) squares += (pixel.x - mean) * (pixel.x - mean);
    return {mean, std::sqrt(squares / (count - 1) / count)};
}

/// Of pixels that show the same but for noise.
Mean mean_difference(const Image& a, const Image& b) {
    Image difference(a.width(), a.height());
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) difference.at(x, y) = a.at(x, y) - b.at(x, y);
    return mean_of(difference);
}

RenderResult traced(const Scene& scene, const RenderSettings& settings) {
    return tracer_tests::render(scene, "bvh", settings);
}

/// A closed room whose walls emit E and reflect rho: E / (1 - rho) everywhere, whatever its shape.
TEST(PathTracer, furnace_is_as_bright_as_the_geometric_series) {
    Scene scene = scene_of("surface lambert colour 0.5 0.5 0.5 emission 1 1 1\ns 0 0 0 3\n");
    scene.lights.clear();  // met by chance alone, and everywhere
    RenderSettings settings = paths(4);
    settings.transport.roulette_level = 255;
    const RenderResult result = traced(scene, settings);
    for (const vec3& pixel : result.image.pixels()) EXPECT_NEAR(pixel.x, 2, 1e-4);
}

TEST(PathTracer, furnace_is_as_bright_when_its_walls_are_sampled_and_paths_end_by_chance) {
    const Scene scene = scene_of("surface lambert colour 0.8 0.8 0.8 emission 1 1 1\ns 0 0 0 3\n");
    ASSERT_EQ(scene.lights.size(), 1u);
    const Mean mean = mean_of(traced(scene, paths(256, 16)).image);
    EXPECT_NEAR(mean.value, 5, 4 * mean.error);
    EXPECT_LT(mean.error, 0.05);
}

std::string wall_lit_by(const std::string& lamp) {
    return "surface lambert colour 0.6 0.6 0.6\np 4\n-9 -9 -3\n9 -9 -3\n9 9 -3\n-9 9 -3\n" + lamp;
}

/// A sphere of radiance L and half-angle a, straight above: irradiance pi L sin^2 a (Lambert).
TEST(PathTracer, a_wall_under_a_sphere_has_the_closed_form_s_radiance) {
    // Seen from the middle of the wall the sphere's centre is 4 off at right angles.
    Scene scene = scene_of(wall_lit_by("light sphere 0 0 1 0.5 3 3 3\n"));
    scene.camera.angle = 0.01f;  // all pixels see one point
    const double sine = 0.5 / 4, irradiance = pi * 3 * sine * sine;
    const double expected = 0.6 / pi * irradiance;
    const Mean mean = mean_of(traced(scene, paths(64)).image);
    EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-4 * expected);
    EXPECT_LT(mean.error, 0.01 * expected);
}

/// The same lamp with and without a body that rays can meet: light samples alone, or both
/// strategies weighed against each other.
TEST(PathTracer, both_strategies_together_agree_with_light_samples_alone) {
    const std::string lamp = "light rectangle -1 1 -1  0 1 0  2 0 0  4 4 4";
    for (const std::string surface :
         {"surface lambert colour 0.6 0.6 0.6\n", "surface conductor roughness 0.5\n",
          "surface cook_torrance colour 0.5 0.5 0.5 specular 1 index 1.5 roughness 0.3\n"}) {
        const std::string wall = surface + "p 4\n-9 -9 -3\n9 -9 -3\n9 9 -3\n-9 9 -3\n";
        RenderSettings settings = paths(256, 16);
        settings.transport.depth = 2;  // light of the lamp alone
        const Scene hidden = scene_of(wall + lamp + "\n");
        Scene bodily = scene_of(wall + lamp + " visible\n");
        const Image alone = traced(hidden, settings).image, both = traced(bodily, settings).image;
        const Mean difference = mean_difference(alone, both);
        EXPECT_LE(std::abs(difference.value), 4 * difference.error) << surface;
        EXPECT_LT(difference.error, 0.02 * mean_of(alone).value) << surface;
    }
}

/// Without a light the sky is all there is: a white diffuser under a sky of 1 shows 1.
TEST(PathTracer, a_white_surface_under_a_white_sky_cannot_be_told_from_it) {
    const Scene scene = scene_of(
        "b 1 1 1\nsurface lambert colour 1 1 1\ns 0 0 -4 1\nsurface dielectric index 1.5\n"
        "s 1.5 0 -5 0.5\nsurface oren_nayar colour 0 0 0\n");
    RenderSettings settings = paths(64, 16);
    settings.transport.roulette_level = 255;
    const Mean mean = mean_of(traced(scene, settings).image);
    EXPECT_NEAR(mean.value, 1, 1e-3);
}

TEST(PathTracer, irradiance_of_the_cache_is_that_of_paths) {
    // A corner of two walls under a lamp: what one sends to the other is interpolated.
    const Scene scene = scene_of(
        "surface lambert colour 0.7 0.7 0.7\np 4\n-2 -1 -1\n2 -1 -1\n2 -1 -6\n-2 -1 -6\n"
        "surface lambert colour 0.7 0.2 0.2\np 4\n-2 -1 -5\n2 -1 -5\n2 2 -5\n-2 2 -5\n"
        "light rectangle -1 2 -4  2 0 0  0 0 1  9 9 9\n");
    RenderSettings by_paths = paths(256, 24);
    RenderSettings by_cache = paths(16, 24);
    by_cache.transport.method = Method::irradiance;
    by_cache.transport.gather = 1024;
    by_cache.transport.cache_error = 0.15f;
    const Image truth = traced(scene, by_paths).image, cached = traced(scene, by_cache).image;
    double difference = 0, total = 0, direct = 0;
    by_paths.transport.depth = 2;
    const Image unreflected = traced(scene, by_paths).image;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
        difference += std::abs(truth.pixels()[i].x - cached.pixels()[i].x);
        total += truth.pixels()[i].x;
        direct += unreflected.pixels()[i].x;
    }
    EXPECT_GT(total - direct, 0.05 * total);  // there is something to interpolate
    EXPECT_LT(difference, 0.03 * total);
    // Mean light as a whole, where errors cancel.
    EXPECT_NEAR(mean_of(cached).value, mean_of(truth).value, 0.02 * mean_of(truth).value);
}

}  // namespace
}  // namespace rayshoot
