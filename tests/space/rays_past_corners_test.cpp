#include <gtest/gtest.h>

#include "accel/core/catalogue.h"
#include "tests/contract/contract.h"
#include "tests/contract/scenes/shapes.h"
#include "tests/contract/truth.h"
#include "tests/core/cases.h"
#include "tests/core/truth.h"

/// Rays from far away, nearly along a face of what they hit: all structures that subdivide space
/// have to find hits that are reported far from their primitive. From nearby no hit is reported
/// there, but many are nearly.
namespace rayshoot::space_test {
namespace {

using contract::Random;

/// Specks, so that there are many small cells, and a few long triangles that reach through many of
/// these.
struct Scene {
    std::vector<Triangle> large;
    Geometry geometry;

    explicit Scene(Precision precision) {
        Random random(1);
        GeometryBuilder builder;
        const Box box{vec3(-1), vec3(1)};
        for (int i = 0; i < 6; ++i) {
            const vec3 a = random.inside(box), b = random.inside(box);
            const float thin = random.power_of_two(-4, -1);
            const vec3 c = a + random.between(-0.5f, 1.5f) * (b - a) + thin * random.inside(box);
            large.push_back({a, b, c});
            builder.add_triangle(large.back().a, large.back().b, large.back().c);
        }
        contract::add_soup(builder, random, box, 0.05f, 300);
        geometry = std::move(builder).build(precision);
    }
};

/// How rays are aimed: by at most this share of their distance beside a corner, and towards its
/// face by a share between these powers of two.
struct Aim {
    float beside;
    int least_slope, largest_slope;
};
constexpr Aim from_far{1e-6f, -16, -2}, from_nearby{2e-6f, -18, -10};

/// Past the corner of a triangle that is outermost along an axis, and hardly towards that axis.
Ray past_a_corner(const Triangle& triangle, float away, const Aim& aim, Random& random) {
    const int across = static_cast<int>(random.below(3));
    const vec3 corners[]{triangle.a, triangle.b, triangle.c};
    vec3 outermost = corners[0];
    for (const vec3& corner : corners)
        if (corner[across] > outermost[across]) outermost = corner;
    Ray ray;
    ray.direction = vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    ray.direction[(across + 1) % 3] = random.coin() ? 1.0f : -1.0f;
    ray.direction[across] *= random.power_of_two(aim.least_slope, aim.largest_slope);
    ray.origin = outermost - away * ray.direction;
    ray.origin[across] += random.between(-1, 1) * away * aim.beside;
    return ray;
}

/// The same line with its end just behind what it hits: whoever looks for the primitive elsewhere
/// comes too late.
Ray ended_behind(const Ray& ray, float t) {
    Ray ended = ray;
    ended.t_max = float_above(float_above(t));
    return ended;
}

/// Whether a hit is reported farther from its triangle than rays from nearby can be, so that no
/// cell made for these needs to hold the triangle.
bool is_far_from_its_triangle(const Scene& scene, const Ray& ray, const Hit& hit) {
    if (hit.primitive >= scene.large.size()) return false;
    const vec3 size = scene.geometry.bounds().size();
    const auto distance = truth::distance(truth::point_at(ray, hit.t), scene.large[hit.primitive]);
    return static_cast<float>(distance) > scene.geometry.error_radius(length(size));
}

struct Questions {
    std::vector<Ray> rays;
    std::vector<Hit> truth;
    int telling = 0;

    void add(const Ray& ray, const contract::Truth& brute_force) {
        rays.push_back(ray);
        truth.push_back(brute_force.closest(ray));
        const Hit hit = truth.back();
        if (hit.primitive == no_primitive) return;
        rays.push_back(ended_behind(ray, hit.t));
        truth.push_back(brute_force.closest(rays.back()));
    }
};

const Triangle& any_large(const Scene& scene, Random& random) {
    return scene.large[random.below(static_cast<std::uint32_t>(scene.large.size()))];
}

/// From 10 to 10^6 scene sizes away: all rays whose hits tell, and some of the others.
Questions asked_from_far(const Scene& scene) {
    Questions questions;
    Random random(2);
    const contract::Truth brute_force(scene.geometry);
    for (int i = 0; i < 600000; ++i) {
        const Triangle& triangle = any_large(scene, random);
        const float away = 20.0f * random.power_of_two(0, i % 4 == 0 ? 16 : 5);
        const Ray ray = past_a_corner(triangle, away, from_far, random);
        const bool tells = is_far_from_its_triangle(scene, ray, brute_force.closest(ray));
        questions.telling += tells;
        if (tells || i % 100 == 0) questions.add(ray, brute_force);
    }
    return questions;
}

/// From within the scene and next to it.
Questions asked_from_nearby(const Scene& scene) {
    Questions questions;
    Random random(3);
    const contract::Truth brute_force(scene.geometry);
    for (int i = 0; i < 2000000; ++i) {
        const std::uint32_t number = random.below(static_cast<std::uint32_t>(scene.large.size()));
        const Triangle& triangle = scene.large[number];
        const float away = random.between(0.5f, 1.5f);
        const Ray ray = past_a_corner(triangle, away, from_nearby, random);
        const bool tells = cases::is_taken_back(triangle, scene.geometry.bounds(number), ray);
        questions.telling += tells;
        if (tells || i % 400 == 0) questions.add(ray, brute_force);
    }
    return questions;
}

void expect_answers(const std::string& spec, const Scene& scene, const Questions& questions) {
    const auto accel = build(built_in_catalogue(), spec, {scene.geometry});
    const auto session = accel->open(Mode::timing);
    int wrong = 0;
    for (std::size_t i = 0; i < questions.rays.size(); i += default_batch) {
        const std::size_t size = std::min(default_batch, questions.rays.size() - i);
        const RayBatch batch{.rays = std::span(questions.rays).subspan(i, size)};
        std::vector<Hit> hits(size);
        std::vector<std::uint8_t> occluded(size);
        session->closest(batch, hits);
        session->occluded(batch, occluded);
        for (std::size_t j = 0; j < size; ++j) {
            const Hit& expected = questions.truth[i + j];
            wrong += hits[j] != expected || occluded[j] != (expected.primitive != no_primitive);
        }
    }
    EXPECT_EQ(wrong, 0) << "of " << questions.rays.size() << " rays";
}

class FarRays : public testing::TestWithParam<std::string> {};
class NearRays : public testing::TestWithParam<std::string> {};

TEST_P(FarRays, are_answered_where_hits_are_reported_far_from_their_triangles) {
    static const Scene scene(Precision::standard);
    static const Questions questions = asked_from_far(scene);
    EXPECT_GE(questions.telling, 10);
    expect_answers(GetParam(), scene, questions);
}

TEST_P(NearRays, are_answered_where_they_pass_triangles_by_a_rounding) {
    static const Scene scene(Precision::standard);
    static const Questions questions = asked_from_nearby(scene);
    EXPECT_GE(questions.telling, 10);
    expect_answers(GetParam(), scene, questions);
}

TEST_P(FarRays, are_answered_with_watertight_triangles) {
    static const Scene scene(Precision::watertight);
    static const Questions questions = asked_from_far(scene);
    expect_answers(GetParam(), scene, questions);
}

/// Of grid, octree and BSP.
std::vector<std::string> subdivisions_of_space() {
    std::vector<std::string> specs;
    for (const std::string& spec : contract::exact_configurations(built_in_catalogue()))
        for (const std::string_view family : {"grid", "octree", "bsp"})
            if (spec == family || spec.starts_with(std::string(family) + ":"))
                specs.push_back(spec);
    return specs;
}

/// GoogleTest allows only letters, digits and underscores.
std::string test_name(const testing::TestParamInfo<std::string>& spec) {
    std::string name = spec.param;
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Catalogue, FarRays, testing::ValuesIn(subdivisions_of_space()), test_name);
INSTANTIATE_TEST_SUITE_P(Catalogue, NearRays, testing::ValuesIn(subdivisions_of_space()),
                         test_name);

}  // namespace
}  // namespace rayshoot::space_test
