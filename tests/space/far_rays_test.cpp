#include <gtest/gtest.h>

#include "accel/core/catalogue.h"
#include "tests/contract/contract.h"
#include "tests/contract/scenes/shapes.h"
#include "tests/contract/truth.h"
#include "tests/core/truth.h"

/// Rays from far away, nearly along a face of what they hit: all structures that subdivide space
/// have to find hits that are reported far from their primitive.
namespace rayshoot::space_test {
namespace {

using contract::Random;

/// Specks, so that there are many small cells, and a few triangles that reach through many of
/// these.
struct Scene {
    std::vector<Triangle> large;
    Geometry geometry;

    explicit Scene(Precision precision) {
        Random random(1);
        GeometryBuilder builder;
        const Box box{vec3(-1), vec3(1)};
        for (int i = 0; i < 6; ++i) {
            large.push_back({random.inside(box), random.inside(box), random.inside(box)});
            builder.add_triangle(large.back().a, large.back().b, large.back().c);
        }
        contract::add_soup(builder, random, box, 0.05f, 300);
        geometry = std::move(builder).build(precision);
    }
};

/// Past the corner of a triangle that is outermost along an axis, and hardly towards that axis.
Ray past_a_corner(const Triangle& triangle, float away, Random& random) {
    const int across = static_cast<int>(random.below(3));
    const vec3 corners[]{triangle.a, triangle.b, triangle.c};
    vec3 outermost = corners[0];
    for (const vec3& corner : corners)
        if (corner[across] > outermost[across]) outermost = corner;
    Ray ray;
    ray.direction = vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    ray.direction[(across + 1) % 3] = random.coin() ? 1.0f : -1.0f;
    ray.direction[across] *= random.power_of_two(-16, -2);
    ray.origin = outermost - away * ray.direction;
    ray.origin[across] += random.between(-1, 1) * away * 1e-6f;
    return ray;
}

/// The same line with its end just behind what it hits: whoever looks for the primitive elsewhere
/// comes too late.
Ray ended_behind(const Ray& ray, float t) {
    Ray ended = ray;
    ended.t_max = float_above(float_above(t));
    return ended;
}

/// Whether a hit is reported farther from its triangle than the error radius for the distance of
/// the ray's origin, so that no cell grown by it needs to hold the triangle.
bool is_far_from_its_triangle(const Scene& scene, const Ray& ray, const Hit& hit) {
    if (hit.primitive >= scene.large.size()) return false;
    const vec3 from_centre = ray.origin - scene.geometry.bounds().centre();
    const float reach = std::sqrt(dot(from_centre, from_centre)) * 1.0001f;
    const auto distance = truth::distance(truth::point_at(ray, hit.t), scene.large[hit.primitive]);
    return static_cast<float>(distance) > 1.5f * scene.geometry.error_radius(reach);
}

struct Questions {
    std::vector<Ray> rays;
    std::vector<Hit> truth;
    int telling = 0;

    /// From 10 to 10^6 scene sizes away: all rays whose hits tell, and some of the others.
    explicit Questions(const Scene& scene) {
        Random random(2);
        const contract::Truth brute_force(scene.geometry);
        for (int i = 0; i < 600000; ++i) {
            const Triangle& triangle =
                scene.large[random.below(static_cast<std::uint32_t>(scene.large.size()))];
            const float away = 20.0f * random.power_of_two(0, i % 4 == 0 ? 16 : 5);
            const Ray ray = past_a_corner(triangle, away, random);
            const Hit hit = brute_force.closest(ray);
            const bool tells = is_far_from_its_triangle(scene, ray, hit);
            if (!tells && i % 100 != 0) continue;
            telling += tells;
            add(ray, hit);
            if (hit.primitive == no_primitive) continue;
            const Ray ended = ended_behind(ray, hit.t);
            add(ended, brute_force.closest(ended));
        }
    }
    void add(const Ray& ray, const Hit& hit) {
        rays.push_back(ray);
        truth.push_back(hit);
    }
};

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

TEST_P(FarRays, are_answered_where_hits_are_reported_far_from_their_triangles) {
    static const Scene scene(Precision::standard);
    static const Questions questions(scene);
    EXPECT_GE(questions.telling, 10);
    expect_answers(GetParam(), scene, questions);
}

TEST_P(FarRays, are_answered_with_watertight_triangles) {
    static const Scene scene(Precision::watertight);
    static const Questions questions(scene);
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

}  // namespace
}  // namespace rayshoot::space_test
