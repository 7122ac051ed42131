#include <gtest/gtest.h>

#include <array>

#include "accel/core/promise.h"
#include "tests/tracer/light/closed_forms.h"
#include "tests/tracer/light/lamps.h"
#include "tests/tracer/stream.h"
#include "tracer/light/lights.h"

namespace rayshoot::tracer_tests {
namespace {

/// Beside nothing: a point in space.
SurfacePoint in_space(const dvec3& position, const vec3& normal) {
    return {position, normal, normal, 0};
}

struct Outcome {
    int rays = 0, blocked = 0, broken = 0;
};

/// Shadow rays from all around a lamp, from near and from afar, half of them grazing it.
Outcome ask(const Lamp& lamp, float size, const vec3& at, std::uint32_t seed) {
    const Lights lights(lamp.scene);
    const Oracle oracle(lamp.scene);
    const BuildInput input{lamp.scene.geometry, {}, lamp.scene.lights, nullptr};
    Stream random(seed);
    Outcome outcome;
    for (int i = 0; i < 4000; ++i) {
        const float far = std::exp2(random.between(-3, 10));
        const Pair pair = random.pair();
        dvec3 from = dvec3(at) + dvec3(random.direction()) * double{size * far};
        if (i % 2) {  // nearly in the plane that the light's point has
            const auto aim = lights.sample(0, from, 0, pair);
            if (!aim) continue;
            const dvec3 sideways = cross(dvec3(aim->direction), dvec3(random.direction()));
            from = aim->point + sideways * double{size * far} - (aim->point - from) * 1e-3;
        }
        const auto sample = lights.sample(0, from, 0, pair);
        if (!sample) continue;
        const Ray ray = shadow_ray(in_space(from, sample->direction), *sample, 0);
        ++outcome.rays;
        outcome.blocked += oracle.occluded(ray);
        const Source source = Source::light(0);
        outcome.broken +=
            !broken_promise(input, {RayKind::shadow, 1, {&ray, 1}, {&source, 1}}).empty();
        EXPECT_LT(ray.t_max, 1);
        EXPECT_GT(ray.t_max, 0.999f);
    }
    return outcome;
}

TEST(ShadowRay, never_meets_the_light_that_it_asks_for) {
    std::uint32_t seed = 0;
    for (const float size : {0x1p-20f, 1.0f, 0x1p20f}) {
        for (const float off : {0.0f, 3.0f, 300.0f}) {
            const vec3 at = size * off * vec3(0.6f, -0.3f, 0.7f);
            for (const auto& lamp : lamps(size, at)) {
                const Outcome outcome = ask(*lamp, size, at, ++seed);
                EXPECT_GT(outcome.rays, 500) << lamp->name;
                EXPECT_EQ(outcome.blocked, 0)
                    << lamp->name << " of size " << size << ", " << off << " sizes away";
                EXPECT_EQ(outcome.broken, 0)
                    << lamp->name << " of size " << size << ", " << off << " sizes away";
            }
        }
    }
}

/// The other side of it: the same rays, a little longer, do meet it. So its clearance is no more
/// than a thousandth of the way, and the test above asks for something.
TEST(ShadowRay, ends_just_before_its_light) {
    for (const auto& lamp : lamps(1, {0, 0, 0})) {
        const Lights lights(lamp->scene);
        const Oracle oracle(lamp->scene);
        Stream random(11);
        int met = 0, rays = 0;
        for (int i = 0; i < 2000; ++i) {
            const dvec3 from = dvec3(random.direction()) * double{random.between(2, 8)};
            const auto sample = lights.sample(0, from, 0, random.pair());
            if (!sample) continue;
            Ray ray = shadow_ray(in_space(from, sample->direction), *sample, 0);
            ray.t_max *= 1.001f;
            ++rays;
            met += oracle.occluded(ray);
        }
        EXPECT_GT(met, 0.95 * rays) << lamp->name;
    }
}

/// What is in between is met, as near to the light as a thousandth of the way.
TEST(ShadowRay, meets_what_is_in_between) {
    for (const float size : {0x1p-20f, 1.0f, 0x1p20f}) {
        Scene scene;
        GeometryBuilder builder;
        const auto add = [&](float height) {
            const std::array<vec3, 4> corners{size * vec3(-1, height, -1),
                                              size * vec3(-1, height, 1), size * vec3(1, height, 1),
                                              size * vec3(1, height, -1)};
            builder.add_polygon(corners);
            scene.material_of.push_back(0);
        };
        add(0);
        add(0.001f);
        scene.materials.emplace_back();
        scene.geometry = std::move(builder).build();
        Light light = rectangle_light(size * vec3(-1, 0, -1), {0, 0, 2 * size}, {2 * size, 0, 0});
        light.primitives = {0};
        light.samples.include(scene.geometry.bounds(0));
        scene.lights.push_back(light);
        const Lights lights(scene);
        const Oracle oracle(scene);
        Stream random(12);
        for (int i = 0; i < 500; ++i) {
            const vec3 from = size * vec3(random.between(-1, 1), 1, random.between(-1, 1));
            const auto sample = lights.sample(0, dvec3(from), 0, random.pair());
            ASSERT_TRUE(sample.has_value());
            EXPECT_TRUE(oracle.occluded(shadow_ray(in_space(dvec3(from), {0, -1, 0}), *sample, 0)));
        }
    }
}

/// From a floor to a lamp that stands on it, neither is in the way.
TEST(ShadowRay, starts_beside_its_surface) {
    Scene scene;
    GeometryBuilder builder;
    const std::array<vec3, 4> floor{vec3(-9, 0, -9), {-9, 0, 9}, {9, 0, 9}, {9, 0, -9}};
    builder.add_polygon(floor);
    builder.add_sphere({{0, 1, 0}, 1});
    scene.geometry = std::move(builder).build();
    scene.materials.emplace_back();
    scene.material_of = {0, 0};
    Light light = sphere_light({0, 1, 0}, 1);
    light.primitives = {1};
    light.samples = scene.geometry.bounds(1);
    scene.lights.push_back(light);
    const Lights lights(scene);
    const Oracle oracle(scene);
    Stream random(13);
    int rays = 0;
    for (int i = 0; i < 3000; ++i) {
        Ray down;
        down.origin = {random.between(-8, 8), 3, random.between(-8, 8)};
        down.direction = {0, -1, 0};
        const Hit hit = oracle.closest(down);
        if (hit.primitive != 0) continue;
        const SurfacePoint at = surface_point(scene.geometry, down, hit);
        const auto sample = lights.sample(0, at.position, 0, random.pair());
        ASSERT_TRUE(sample.has_value());
        if (sample->direction.y <= 0) continue;
        ++rays;
        EXPECT_FALSE(oracle.occluded(shadow_ray(at, *sample, 0)));
    }
    EXPECT_GT(rays, 1000);
}

/// A lamp that moves is asked for where it is.
TEST(ShadowRay, follows_a_moving_light) {
    Motion motion;
    motion.translation[1] = {4, 1, 0};
    motion.rotation[1] = {0, 0, 0.5f, std::sqrt(0.75f)};
    for (const bool sphere : {true, false}) {
        Scene scene;
        GeometryBuilder builder;
        const std::uint32_t moving = builder.add_motion(motion);
        const std::array<vec3, 4> corners{vec3(0, 5, 0), {1, 5, 0}, {1, 5, 1}, {0, 5, 1}};
        Light light =
            sphere ? sphere_light({0, 5, 0}, 1) : rectangle_light(corners[0], {1, 0, 0}, {0, 0, 1});
        if (sphere) builder.add_sphere({{0, 5, 0}, 1}, moving);
        else builder.add_polygon(corners, {}, moving);
        scene.geometry = std::move(builder).build();
        scene.materials.emplace_back();
        scene.material_of = {0};
        light.primitives = {0};
        light.samples = scene.geometry.bounds();
        scene.lights.push_back(light);
        const Lights lights(scene);
        const Oracle oracle(scene);
        const BuildInput input{scene.geometry, {}, scene.lights, nullptr};
        Stream random(14);
        int met = 0, rays = 0;
        for (int i = 0; i < 2000; ++i) {
            const float time = random.number();
            const dvec3 from(random.between(-3, 3), -2, random.between(-3, 3));
            const auto sample = lights.sample(0, from, time, random.pair());
            if (!sample) continue;
            ++rays;
            Ray ray = shadow_ray(in_space(from, sample->direction), *sample, time);
            EXPECT_FALSE(oracle.occluded(ray));
            const Source source = Source::light(0);
            EXPECT_EQ(broken_promise(input, {RayKind::shadow, 1, {&ray, 1}, {&source, 1}}), "");
            ray.t_max = 1.001f;
            const Hit hit = oracle.closest(ray);
            if (hit.primitive == no_primitive) continue;
            ++met;
            const SurfacePoint at = surface_point(scene.geometry, ray, hit);
            EXPECT_NEAR(lights.pdf(0, from, at, time) / sample->pdf, 1, 1e-3);
        }
        EXPECT_GT(rays, 500);
        EXPECT_GT(met, 0.95 * rays);
    }
}

/// A strip light at height 4, an edge at height 2 that keeps out what comes from x < 0.
class Penumbra : public testing::Test {
protected:
    static constexpr double width = 1, lamp_height = 4, edge_height = 2;

    Penumbra() {
        GeometryBuilder builder;
        const std::array<vec3, 4> blocker{vec3(-50, edge_height, -50),
                                          {-50, edge_height, 50},
                                          {0, edge_height, 50},
                                          {0, edge_height, -50}};
        builder.add_polygon(blocker);
        scene.geometry = std::move(builder).build();
        scene.materials.emplace_back();
        scene.material_of = {0};
        scene.lights.push_back(
            rectangle_light({-width / 2, lamp_height, -10}, {width, 0, 0}, {0, 0, 20}));
    }
    /// Where the line from x on the floor over the edge meets the light's plane.
    static double edge_on_light(double x) { return x * (1 - lamp_height / edge_height); }

    Scene scene;
};

TEST_F(Penumbra, of_a_straight_edge_is_the_linear_ramp) {
    const Lights lights(scene);
    const Oracle oracle(scene);
    constexpr int strata = 400;  // across the light: the share of it is off by less than 1 / 400
    Stream random(15);
    for (double x = -1; x <= 1; x += 0.1) {
        int seen = 0;
        for (int i = 0; i < strata; ++i) {
            const Pair pair{(static_cast<float>(i) + random.number()) / strata, random.number()};
            const dvec3 from(x, 0, 0);
            const auto sample = lights.sample(0, from, 0, pair);
            ASSERT_TRUE(sample.has_value());
            seen += !oracle.occluded(shadow_ray(in_space(from, {0, 1, 0}), *sample, 0));
        }
        const double ramp = std::clamp((width / 2 - edge_on_light(x)) / width, 0.0, 1.0);
        EXPECT_NEAR(static_cast<double>(seen) / strata, ramp, 1.0 / strata + 1e-9) << x;
    }
}

/// Its irradiance is that of the part in sight, by Lambert's formula.
TEST_F(Penumbra, has_the_irradiance_of_what_is_in_sight) {
    const Lights lights(scene);
    const Oracle oracle(scene);
    constexpr int count = 40'000;
    Stream random(16);
    for (const double x : {-0.3, 0.0, 0.2, 0.45}) {
        const dvec3 from(x, 0, 0);
        double sum = 0, squares = 0;
        for (int i = 0; i < count; ++i) {
            const auto sample = lights.sample(0, from, 0, random.pair());
            const bool lit = !oracle.occluded(shadow_ray(in_space(from, {0, 1, 0}), *sample, 0));
            const double value = lit ? sample->incident.x * sample->direction.y : 0;
            sum += value;
            squares += value * value;
        }
        const double mean = sum / count;
        const double deviation = std::sqrt((squares / count - mean * mean) / count);
        const double edge = std::clamp(edge_on_light(x), -width / 2, width / 2);
        const std::array<dvec3, 4> seen{dvec3(edge, lamp_height, -10),
                                        {width / 2, lamp_height, -10},
                                        {width / 2, lamp_height, 10},
                                        {edge, lamp_height, 10}};
        EXPECT_NEAR(mean, polygon_irradiance(from, {0, 1, 0}, seen), 4.5 * deviation) << x;
    }
}

}  // namespace
}  // namespace rayshoot::tracer_tests
