#include <gtest/gtest.h>

#include <array>

#include "tests/tracer/test_scenes.h"
#include "tracer/random.h"
#include "tracer/surface.h"

namespace rayshoot {
namespace {

/// Numbers one after the other.
class Stream {
public:
    explicit Stream(std::uint32_t seed) : random_(seed, 0, 0) {}
    float between(float lo, float hi) { return lo + (hi - lo) * random_.number(next_++); }
    vec3 in_cube() { return {between(-1, 1), between(-1, 1), between(-1, 1)}; }

private:
    RandomSequence random_;
    std::uint32_t next_ = 0;
};

/// Brute force, one ray at a time.
class Oracle {
public:
    explicit Oracle(const Geometry& geometry)
        : accel_(build(built_in_catalogue(), "brute_force", BuildInput{geometry})),
          session_(accel_->open(Mode::timing)) {}
    Hit closest(const Ray& ray) const {
        Hit hit;
        session_->closest({RayKind::secondary, 1, {&ray, 1}, {}}, {&hit, 1});
        return hit;
    }

private:
    std::unique_ptr<Accel> accel_;
    std::unique_ptr<Session> session_;
};

struct Case {
    Geometry geometry;
    float size = 1;       ///< of the primitive
    vec3 aim;             ///< a point near it, ...
    float spread = 0.3f;  ///< ... and how far round it rays are aimed, of the size
};

using MakeCase = Case (*)(Stream&, const vec3& offset, float size);

Case triangle_case(Stream& random, const vec3& offset, float size) {
    const std::array<vec3, 3> corner{offset + size * random.in_cube(),
                                     offset + size * random.in_cube(),
                                     offset + size * random.in_cube()};
    GeometryBuilder builder;
    builder.add_triangle(corner[0], corner[1], corner[2]);
    return {std::move(builder).build(), size, (corner[0] + corner[1] + corner[2]) / 3.0f};
}

/// A hundred times as long as wide.
Case needle_case(Stream& random, const vec3& offset, float size) {
    const vec3 a = offset + size * random.in_cube(), b = offset + size * random.in_cube();
    const vec3 c = b + 0.01f * size * random.in_cube();
    GeometryBuilder builder;
    builder.add_triangle(a, b, c);
    return {std::move(builder).build(), size, (a + b + c) / 3.0f, 0.003f};
}

Case polygon_case(Stream& random, const vec3& offset, float size) {
    const vec3 a = size * random.in_cube(), b = size * random.in_cube();
    const std::array<vec3, 4> corners{offset, offset + a, offset + a + b, offset + b};
    GeometryBuilder builder;
    builder.add_polygon(corners);
    return {std::move(builder).build(), size, offset + 0.5f * (a + b)};
}

Case sphere_case(Stream& random, const vec3& offset, float size) {
    GeometryBuilder builder;
    builder.add_sphere({offset + size * random.in_cube(), size});
    return {std::move(builder).build(), size, offset};
}

Case frustum_case(Stream& random, const vec3& offset, float size) {
    GeometryBuilder builder;
    builder.add_frustum({offset, size * random.between(0.2f, 1),
                         offset + size * normalised(random.in_cube()),
                         size * random.between(0.2f, 1)});
    return {std::move(builder).build(), size, offset};
}

/// What a run of a case found.
struct Outcome {
    int hits = 0;
    int caught = 0;       ///< rays that met the surface they left, at t > 0
    double furthest = 0;  ///< offset over |position| + size + distance travelled
};

bool leaves_for_good(const Geometry& geometry, const vec3& normal, const vec3& direction) {
    const PrimitiveKind kind = geometry.ref(0).kind;
    if (kind == PrimitiveKind::triangle || kind == PrimitiveKind::polygon) return true;
    return dot(normal, direction) > 0;  // outwards from a convex surface
}

Outcome run(MakeCase make, const vec3& offset, float size, std::uint32_t seed) {
    Stream random(seed);
    Outcome outcome;
    for (int round = 0; round < 300; ++round) {
        const Case test = make(random, offset, size);
        const Oracle oracle(test.geometry);
        Ray ray;
        ray.origin = test.aim + size * random.between(2, 1000) * normalised(random.in_cube());
        ray.direction = test.aim + test.spread * size * random.in_cube() - ray.origin;
        const Hit hit = oracle.closest(ray);
        if (hit.primitive == no_primitive) continue;
        ++outcome.hits;
        const SurfacePoint point = surface_point(test.geometry, ray, hit);
        for (int spawned = 0; spawned < 20; ++spawned) {
            // Half of them graze.
            const vec3 any = normalised(random.in_cube());
            const vec3 flat = any - point.geometric * dot(any, point.geometric);
            Ray leaving;
            leaving.direction =
                spawned % 2 ? any : flat + point.geometric * random.between(-0.01f, 0.01f);
            if (!leaves_for_good(test.geometry, point.geometric, leaving.direction)) continue;
            leaving.origin = spawn_origin(point, leaving.direction);
            outcome.caught += oracle.closest(leaving).primitive != no_primitive;
            const dvec3 away = dvec3(leaving.origin) - point.position;
            const double travelled = length(point.position - dvec3(ray.origin));
            outcome.furthest = std::max(outcome.furthest,
                                        length(away) / (length(point.position) + size + travelled));
        }
    }
    return outcome;
}

struct Named {
    const char* name;
    MakeCase make;
    double furthest;  ///< allowed
};

class Spawn : public testing::TestWithParam<Named> {};

TEST_P(Spawn, rays_never_meet_the_surface_that_they_leave) {
    std::uint32_t seed = 0;
    for (const float size : {0x1p-20f, 1.0f, 0x1p20f}) {
        for (const float distance : {0.0f, 1.0f, 100.0f, 10000.0f}) {
            const vec3 offset = vec3(0.6f, -0.7f, 0.3f) * (distance * size);
            const Outcome outcome = run(GetParam().make, offset, size, ++seed);
            EXPECT_GT(outcome.hits, 30) << size << " " << distance;
            EXPECT_EQ(outcome.caught, 0) << size << " " << distance;
        }
    }
}

TEST_P(Spawn, origins_stay_within_rounding_of_the_surface) {
    for (const float size : {0x1p-20f, 1.0f, 0x1p20f}) {
        const Outcome outcome = run(GetParam().make, vec3(3 * size), size, 99);
        EXPECT_LT(outcome.furthest, GetParam().furthest) << size;
    }
}

INSTANTIATE_TEST_SUITE_P(Primitives, Spawn,
                         testing::Values(Named{"triangle", triangle_case, 1e-3},
                                         Named{"needle", needle_case, 1e-1},
                                         Named{"polygon", polygon_case, 1e-6},
                                         Named{"sphere", sphere_case, 1e-6},
                                         Named{"frustum", frustum_case, 1e-6}),
                         [](const auto& named) { return std::string(named.param.name); });

TEST(Spawn, rays_into_a_sphere_find_its_far_side) {
    GeometryBuilder builder;
    builder.add_sphere({{10, 20, 30}, 2});
    const Geometry geometry = std::move(builder).build();
    const Oracle oracle(geometry);
    Stream random(4);
    for (int round = 0; round < 2000; ++round) {
        const vec3 normal = normalised(random.in_cube());
        const vec3 inwards = normalised(normalised(random.in_cube()) - normal);
        const double chord = -4 * dot(dvec3(normal), dvec3(inwards));
        if (chord < 1e-2) continue;
        const SurfacePoint point{dvec3(10, 20, 30) + 2.0 * dvec3(normal), normal, normal, 1e-5};
        Ray ray;
        ray.direction = inwards;
        ray.origin = spawn_origin(point, inwards);
        const Hit hit = oracle.closest(ray);
        EXPECT_NEAR(hit.t, chord, 1e-2 * chord + 1e-3);
    }
}

TEST(Surface, movers_are_met_where_they_are) {
    GeometryBuilder builder;
    Motion motion;
    motion.pivot = {0, 0, 1};
    motion.translation = {vec3(0), vec3(4, 0, 0)};
    const float half = std::sqrt(0.5f);
    motion.rotation = {Motion::Quaternion{0, 0, 0, 1}, {0, 0, half, half}};  // 90 degrees about z
    const std::uint32_t number = builder.add_motion(motion);
    builder.add_triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, number);
    const Geometry geometry = std::move(builder).build();
    Ray ray;
    ray.origin = {4, 0, 5};
    ray.direction = {0, 0, -1};
    ray.time = 1;
    const Oracle oracle(geometry);
    const Hit hit = oracle.closest(ray);
    ASSERT_EQ(hit.primitive, 0u);
    const SurfacePoint point = surface_point(geometry, ray, hit);
    EXPECT_NEAR(point.position.x, 4, 1e-5);
    EXPECT_NEAR(point.position.y, 0, 1e-5);
    EXPECT_NEAR(point.position.z, 0, 1e-5);
    EXPECT_GT(spawn_origin(point, {0, 0, 1}).z, 0);
    EXPECT_LT(spawn_origin(point, {0, 0, -1}).z, 0);
}

}  // namespace
}  // namespace rayshoot
