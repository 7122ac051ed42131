#include "tracer/light/lights.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/tracer/light/closed_forms.h"
#include "tests/tracer/light/lamps.h"
#include "tests/tracer/stream.h"

namespace rayshoot::tracer_tests {
namespace {

constexpr double pi_ = std::numbers::pi;

/// A mean of many, and how far off it may be.
struct Mean {
    double sum = 0, squares = 0;
    int count = 0;

    void add(double value) {
        sum += value;
        squares += value * value;
        ++count;
    }
    double value() const { return sum / count; }
    /// 4.5 standard deviations: exceeded once in 150 000 tests by chance; and float's rounding.
    double slack() const {
        const double variance = std::max(0.0, squares / count - value() * value());
        return 4.5 * std::sqrt(variance / count) + 1e-5 * std::abs(value());
    }
};

struct Estimate {
    Mean irradiance, solid_angle;
};

constexpr int samples = 40'000;

Estimate estimate(const Scene& scene, const dvec3& from, const dvec3& normal) {
    const Lights lights(scene);
    Stream random(1);
    Estimate estimate;
    for (int i = 0; i < samples; ++i) {
        const auto sample = lights.sample(0, from, 0, random.pair());
        const double cosine = sample ? dot(dvec3(sample->direction), normal) : 0;
        estimate.irradiance.add(sample ? sample->incident.x * std::max(0.0, cosine) : 0);
        estimate.solid_angle.add(sample ? 1 / sample->pdf : 0);
    }
    return estimate;
}

void expect(const Estimate& estimate, double irradiance, double solid_angle) {
    EXPECT_NEAR(estimate.irradiance.value(), irradiance, estimate.irradiance.slack());
    EXPECT_NEAR(estimate.solid_angle.value(), solid_angle, estimate.solid_angle.slack());
}

TEST(Lights, rectangle_gives_lamberts_irradiance) {
    const vec3 corner(-1, 2, 0.5f), u(2, 0.3f, -0.5f), v(0.5f, -0.2f, 2);
    const Scene scene = lit_by(rectangle_light(corner, u, v));
    const dvec3 from(0.2, -0.5, 0.3), normal = normalised(dvec3(0.2, 1, -0.1));
    const dvec3 a(corner), b = a + dvec3(u), c = b + dvec3(v), d = a + dvec3(v);
    const std::array<dvec3, 4> corners{a, b, c, d};
    ASSERT_GT(dot(cross(dvec3(u), dvec3(v)), from - a), 0) << "is seen from behind";
    expect(estimate(scene, from, normal), polygon_irradiance(from, normal, corners),
           triangle_solid_angle(from, a, b, c) + triangle_solid_angle(from, a, c, d));
}

TEST(Lights, shines_to_the_side_of_its_normal_only) {
    const Scene up = lit_by(rectangle_light({-1, 0, -1}, {0, 0, 2}, {2, 0, 0}));
    const Scene down = lit_by(rectangle_light({-1, 0, -1}, {2, 0, 0}, {0, 0, 2}));
    EXPECT_TRUE(Lights(up).sample(0, {0, 1, 0}, 0, {0.4f, 0.4f}).has_value());
    EXPECT_FALSE(Lights(up).sample(0, {0, -1, 0}, 0, {0.4f, 0.4f}).has_value());
    EXPECT_FALSE(Lights(down).sample(0, {0, 1, 0}, 0, {0.4f, 0.4f}).has_value());
}

TEST(Lights, disc_gives_its_irradiance_on_the_axis) {
    for (const float height : {0.2f, 1.0f, 20.0f}) {
        const Scene scene = lit_by(disc_light({1, height, 2}, {0, -1, 0}, 1.5f));
        expect(estimate(scene, {1, 0, 2}, {0, 1, 0}), disc_irradiance(1.5, height),
               disc_solid_angle(1.5, height));
    }
}

TEST(Lights, sphere_gives_the_projected_solid_angle) {
    const dvec3 centre(0.3, 4, -0.2), normal(0, 1, 0);
    for (const float radius : {1e-4f, 0.1f, 1.0f, 3.5f}) {
        const Scene scene = lit_by(sphere_light(vec3(centre), radius));
        const double distance = length(dvec3(vec3(centre)));
        const double cosine = dvec3(vec3(centre)).y / distance;
        expect(estimate(scene, dvec3(0), normal), sphere_irradiance(radius, distance, cosine),
               sphere_solid_angle(radius, distance));
    }
}

/// From inside light comes from everywhere, whatever the place.
TEST(Lights, sphere_shines_on_what_is_inside) {
    const Scene scene = lit_by(sphere_light({0, 0, 0}, 2));
    for (const double off : {0.0, 0.7, 1.99})
        expect(estimate(scene, {off, 0, 0}, normalised(dvec3(1, 1, 0))), pi_, 4 * pi_);
}

/// Resting or moving, near the origin or far from it.
TEST(Lights, sphere_does_not_light_itself_from_outside) {
    Motion motion;
    motion.translation[1] = {4, 1, 0};
    motion.rotation[1] = {0, 0, 0.5f, std::sqrt(0.75f)};
    Stream random(5);
    for (int i = 0; i < 2000; ++i) {
        const vec3 centre = (i % 4 < 2 ? 1.0f : 300.0f) * random.in_cube();
        GeometryBuilder builder;
        const std::uint32_t moving = builder.add_motion(motion);
        builder.add_sphere({centre, 1.7f}, i % 2 ? moving : no_motion);
        Scene scene = lit_by(sphere_light(centre, 1.7f));
        scene.geometry = std::move(builder).build();
        scene.materials.emplace_back();
        scene.material_of = {0};
        scene.lights[0].primitives = {0};
        scene.lights[0].samples = scene.geometry.bounds();
        Ray ray;
        ray.origin = centre + 20.0f * random.direction();
        ray.direction = scene.geometry.bounds().centre() + random.in_cube() - ray.origin;
        ray.time = random.number();
        const Hit hit = Oracle(scene).closest(ray);
        if (hit.primitive == no_primitive) continue;
        const SurfacePoint at = surface_point(scene.geometry, ray, hit);
        const auto sample = Lights(scene).sample(0, at.position, ray.time, random.pair());
        ASSERT_TRUE(sample.has_value());
        EXPECT_LT(dot(sample->direction, at.geometric), 1e-5f) << i;
    }
}

/// What is seen of a convex mesh is a sum of triangles.
TEST(Lights, triangles_give_lamberts_irradiance) {
    GeometryBuilder builder;
    const std::array<vec3, 4> p{vec3(-1, 3, -1), vec3(1, 3, -1), vec3(0, 3.5f, 2), vec3(2, 4, 1)};
    builder.add_triangle(p[0], p[1], p[2]);
    builder.add_triangle(p[1], p[3], p[2]);
    Scene scene;
    scene.geometry = std::move(builder).build();
    scene.materials.emplace_back();
    scene.material_of = {0, 0};
    Light light;
    light.kind = LightKind::triangles;
    light.primitives = {0, 1};
    light.samples = scene.geometry.bounds();
    scene.lights.push_back(light);
    const dvec3 from(0, 0, 0), normal(0, 1, 0);
    double irradiance = 0, solid_angle = 0;
    for (const std::array<std::size_t, 3>& t : {std::array<std::size_t, 3>{0, 1, 2}, {1, 3, 2}}) {
        const std::array<dvec3, 3> corners{dvec3(p[t[0]]), dvec3(p[t[1]]), dvec3(p[t[2]])};
        irradiance += polygon_irradiance(from, normal, corners);
        solid_angle += triangle_solid_angle(from, corners[0], corners[1], corners[2]);
    }
    expect(estimate(scene, from, normal), irradiance, solid_angle);
}

/// Rays that go anywhere meet the light with the density that pdf gives sample().
TEST(Lights, pdf_integrates_to_one_over_what_rays_meet) {
    for (const auto& lamp : lamps(1, {0.5f, -0.3f, 0.8f})) {
        const Lights lights(lamp->scene);
        const Oracle oracle(lamp->scene);
        const dvec3 from(1.5, 2, 1.6);
        Stream random(3);
        Mean inverse;  // of the share that is in sight
        for (int i = 0; i < 40'000; ++i) {
            Ray ray;
            ray.origin = vec3(from);
            ray.direction = random.direction();
            const Hit hit = oracle.closest(ray);
            double density = 0;
            if (hit.primitive != no_primitive) {
                const SurfacePoint at = surface_point(lamp->scene.geometry, ray, hit);
                density = lights.pdf(lights.light_of(hit.primitive), from, at, 0);
            }
            inverse.add(4 * pi_ * density);
        }
        Mean in_sight;
        for (int i = 0; i < 20'000; ++i) {
            const auto sample = lights.sample(0, from, 0, random.pair());
            bool seen = false;
            if (sample) {
                Ray ray;
                ray.origin = vec3(from);
                ray.direction = vec3(sample->point - from);
                ray.t_max = sample->end;
                seen = !oracle.occluded(ray);
            }
            in_sight.add(seen);
        }
        EXPECT_NEAR(inverse.value(), in_sight.value(), inverse.slack() + in_sight.slack() + 2e-3)
            << lamp->name;
    }
}

/// A hit where sample() went has the density that sample() said.
TEST(Lights, pdf_of_a_hit_is_that_of_its_sample) {
    for (const auto& lamp : lamps(1, {0, 0, 0})) {
        const Lights lights(lamp->scene);
        const Oracle oracle(lamp->scene);
        Stream random(4);
        int met = 0;
        for (int i = 0; i < 3000; ++i) {
            const dvec3 from = 3.0 * dvec3(random.in_cube());
            const auto sample = lights.sample(0, from, 0, random.pair());
            if (!sample) continue;
            Ray ray;
            ray.origin = vec3(from);
            ray.direction = sample->direction;
            const Hit hit = oracle.closest(ray);
            if (hit.primitive == no_primitive) continue;
            const SurfacePoint at = surface_point(lamp->scene.geometry, ray, hit);
            // Another part of the light may be in front; and grazing hits jump.
            if (length(at.position - from) < 0.999 * sample->distance) continue;
            if (std::abs(dot(at.geometric, sample->direction)) < 0.02f) continue;
            ++met;
            ASSERT_NEAR(lights.pdf(0, from, at, 0) / sample->pdf, 1, 2e-4) << lamp->name;
        }
        EXPECT_GT(met, 500) << lamp->name;
    }
}

Light point_light() {
    Light light;
    light.position = {1, 2, 3};
    light.intensity = {5, 4, 3};
    light.samples.include(light.position);
    return light;
}

TEST(Lights, point_falls_off_with_the_square_or_not_at_all) {
    Light light = point_light();
    const auto sample = [&] {
        const Scene scene = lit_by(light);
        return *Lights(scene).sample(0, {1, 2, 7}, 0, {});
    };
    EXPECT_NEAR(sample().incident.x, 5 * pi_, 1e-5);
    light.falloff = Falloff::inverse_square;
    EXPECT_NEAR(sample().incident.x, 5.0 / 16, 1e-6);
    EXPECT_EQ(sample().direction, vec3(0, 0, -1));
    EXPECT_EQ(sample().distance, 4);
    EXPECT_EQ(sample().pdf, 0);
}

TEST(Lights, spot_fades_from_the_inner_to_the_outer_cone) {
    Light light = point_light();
    light.kind = LightKind::spot;
    light.falloff = Falloff::inverse_square;
    light.direction = {0, -1, 0};
    light.cos_inner = 0.9f;
    light.cos_outer = 0.7f;
    const Scene scene = lit_by(light);
    const Lights lights(scene);
    for (const double cosine : {1.0, 0.95, 0.9, 0.85, 0.8, 0.75, 0.7001}) {
        const double sine = std::sqrt(1 - cosine * cosine);
        const dvec3 from = dvec3(light.position) + 2.0 * dvec3(sine, -cosine, 0);
        const double share = std::min(1.0, (cosine - 0.7) / 0.2);
        const auto sample = lights.sample(0, from, 0, {});
        ASSERT_TRUE(sample.has_value()) << cosine;
        EXPECT_NEAR(sample->incident.x, 5.0 / 4 * share, 1e-5) << cosine;
    }
    EXPECT_FALSE(lights.sample(0, dvec3(light.position) + dvec3(2, -1, 0), 0, {}).has_value());
    EXPECT_FALSE(lights.sample(0, dvec3(light.position) + dvec3(0, 1, 0), 0, {}).has_value());
}

TEST(Lights, directional_is_infinitely_far) {
    Light light;
    light.kind = LightKind::directional;
    light.direction = {0, -1, 0};
    light.intensity = vec3(2);
    light.falloff = Falloff::inverse_square;
    const Scene scene = lit_by(light);
    const auto sample = Lights(scene).sample(0, {5, 6, 7}, 0.5f, {});
    EXPECT_EQ(sample->direction, vec3(0, 1, 0));
    EXPECT_EQ(sample->distance, infinity);
    EXPECT_EQ(sample->incident, vec3(2));
    const Ray ray = shadow_ray({dvec3(5, 6, 7), {0, 1, 0}, {0, 1, 0}, 0}, *sample, 0.5f);
    EXPECT_EQ(ray.t_max, infinity);
    EXPECT_EQ(ray.time, 0.5f);
}

/// Strata of the pair are strata of the light: the quarters of the square meet in one point.
TEST(Lights, strata_stay_strata) {
    const Scene scene = lit_by(rectangle_light({0, 0, 0}, {4, 0, 0}, {0, 4, 0}));
    const Lights lights(scene);
    Stream random(6);
    for (int i = 0; i < 1000; ++i) {
        const Pair pair = random.pair();
        const auto sample = lights.sample(0, {1, 1, 5}, 0, pair);
        EXPECT_NEAR(sample->point.x, 4 * pair.u, 1e-6);
        EXPECT_NEAR(sample->point.y, 4 * pair.v, 1e-6);
    }
}

TEST(Lights, are_chosen_by_power) {
    Scene scene = lit_by(rectangle_light({0, 0, 0}, {1, 0, 0}, {0, 2, 0}));  // power 2 pi
    scene.lights.push_back(sphere_light({5, 0, 0}, 0.5f));                   // pi^2
    scene.lights.push_back(point_light());
    scene.lights.back().intensity = vec3(0);
    scene.lights.push_back(point_light());  // 4 pi 4
    scene.lights.back().falloff = Falloff::inverse_square;
    const Lights lights(scene);
    const double all = 2 * pi_ + pi_ * pi_ + 16 * pi_;
    const std::array<double, 4> expected{2 * pi_ / all, pi_ * pi_ / all, 0, 16 * pi_ / all};
    std::array<int, 4> count{};
    constexpr int draws = 100'000;
    for (int i = 0; i < draws; ++i) {
        const auto chosen = lights.choose((static_cast<float>(i) + 0.5f) / draws);
        ++count.at(chosen.light);
        EXPECT_EQ(chosen.probability, lights.probability(chosen.light));
    }
    for (std::uint32_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(lights.probability(i), expected[i], 1e-6);
        EXPECT_NEAR(static_cast<double>(count[i]) / draws, expected[i], 2e-5);
    }
    EXPECT_NE(lights.choose(1 - 0x1p-24f).light, no_light);
}

TEST(Lights, without_power_are_chosen_alike_and_none_if_there_are_none) {
    Scene scene = lit_by(point_light());
    scene.lights.push_back(point_light());
    for (Light& light : scene.lights) light.intensity = vec3(0);
    EXPECT_EQ(Lights(scene).probability(1), 0.5f);
    const Scene dark;
    EXPECT_EQ(Lights(dark).choose(0.5f).light, no_light);
}

TEST(Lights, emit_what_is_sampled_and_others_what_their_material_does) {
    Scene scene;
    GeometryBuilder builder;
    const std::array<vec3, 4> corners{vec3(0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    builder.add_polygon(corners);
    builder.add_sphere({{5, 0, 0}, 1});
    scene.geometry = std::move(builder).build();
    scene.materials.resize(2);
    scene.materials[0].emission = vec3(9);
    scene.materials[1].emission = vec3(3);
    scene.material_of = {0, 1};
    Light light = rectangle_light({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    light.intensity = vec3(7);
    light.primitives = {0};
    scene.lights.push_back(light);
    const Lights lights(scene);
    const SurfacePoint at{dvec3(0), {0, 0, 1}, {0, 0, 1}, 0};
    EXPECT_EQ(lights.light_of(0), 0u);
    EXPECT_EQ(lights.light_of(1), no_light);
    EXPECT_EQ(lights.emitted(0, at, {0, 0, 1}), vec3(7));
    EXPECT_EQ(lights.emitted(0, at, {0, 0, -1}), vec3(0));
    EXPECT_EQ(lights.emitted(1, at, {0, 0, 1}), vec3(3));
    EXPECT_EQ(lights.emitted(1, at, {0, 0, -1}), vec3(3));
}

TEST(Lights, refuse_what_is_no_light) {
    const auto refused = [](const Light& good, auto change) {
        Scene scene = lit_by(good);
        EXPECT_NO_THROW(Lights{scene});
        change(scene);
        EXPECT_THROW(Lights{scene}, std::invalid_argument);
    };
    const Light rectangle = rectangle_light({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    refused(point_light(), [](Scene& s) { s.lights[0].intensity.x = -1; });
    refused(point_light(), [](Scene& s) { s.lights[0].samples = {}; });
    refused(point_light(), [](Scene& s) { s.lights[0].position.x += 1; });
    refused(rectangle, [](Scene& s) { s.lights[0].edge_u = s.lights[0].edge_v; });
    refused(rectangle, [](Scene& s) { s.lights[0].edge_u.x = 2; });
    refused(rectangle, [](Scene& s) { s.lights[0].primitives = {0}; });
    refused(sphere_light({0, 0, 0}, 1), [](Scene& s) { s.lights[0].radius = 0; });
    refused(disc_light({0, 0, 0}, {0, 1, 0}, 1), [](Scene& s) { s.lights[0].direction.y = 2; });
    const auto lamp = std::move(lamps(1, {0, 0, 0}).front());
    EXPECT_NO_THROW(Lights{lamp->scene});
    Scene& scene = lamp->scene;
    scene.lights.push_back(scene.lights[0]);
    EXPECT_THROW(Lights{scene}, std::invalid_argument);  // one primitive, two lights
    scene.lights.pop_back();
    std::swap(scene.lights[0].edge_u, scene.lights[0].edge_v);
    EXPECT_THROW(Lights{scene}, std::invalid_argument);  // faces the other way
    std::swap(scene.lights[0].edge_u, scene.lights[0].edge_v);
    scene.lights[0].edge_u *= 0.5f;
    EXPECT_THROW(Lights{scene}, std::invalid_argument);  // is smaller than its polygon
}

}  // namespace
}  // namespace rayshoot::tracer_tests
