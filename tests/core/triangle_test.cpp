#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "accel/core/leaves.h"
#include "tests/core/cases.h"
#include "tests/core/truth.h"

namespace rayshoot {
namespace {

using Rational = boost::multiprecision::cpp_rational;

struct Vector {
    Rational x, y, z;

    explicit Vector(const vec3& p) : x(p.x), y(p.y), z(p.z) {}
    Vector(Rational a, Rational b, Rational c) : x(a), y(b), z(c) {}
};

Vector minus(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

/// Twice the signed area or six times the volume: exact.
Rational determinant(const Vector& a, const Vector& b, const Vector& c) {
    return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
           a.z * (b.x * c.y - b.y * c.x);
}

/// Exact: the line's weights of the three corners (they sum to 1), none when it is parallel.
struct Weights {
    bool parallel = true;
    double a = 0, b = 0, c = 0, t = 0;

    Weights(const Triangle& triangle, const Ray& ray) {
        const Vector o(ray.origin), d(ray.direction), p(triangle.a);
        const Vector e1 = minus(Vector(triangle.b), p), e2 = minus(Vector(triangle.c), p);
        const Vector s = minus(o, p);
        const Rational whole = determinant(d, e1, e2);
        if (whole == 0) return;
        parallel = false;
        const Rational u = determinant(d, s, e2) / whole, v = determinant(d, e1, s) / whole;
        a = Rational(1 - u - v).convert_to<double>();
        b = u.convert_to<double>();
        c = v.convert_to<double>();
        t = Rational(-determinant(s, e1, e2) / whole).convert_to<double>();
    }
    double least() const { return std::min({a, b, c}); }
};

struct Answer {
    bool hit = false;
    float t = 0, u = 0, v = 0;
};

template <class Test>
Answer ask(const Triangle& triangle, const Ray& ray, Test&& test) {
    Answer answer;
    test(triangle, TestRay(ray, Precision::watertight), [&](float t, float u, float v) {
        answer = {true, t, u, v};
    });
    return answer;
}

constexpr auto ordinary = [](const auto& shape, const TestRay& ray, auto&& accept) {
    intersect(shape, ray, accept);
};
constexpr auto watertight = [](const Triangle& triangle, const TestRay& ray, auto&& accept) {
    intersect_watertight(triangle, ray, accept);
};

/// Whether a line that is this far inside (in weights) can be told from one outside: the error of a
/// weight is that of a position, which README bounds, over the height of the corner.
template <class Test>
void expect_exact_decisions(std::uint64_t seed, Test&& test, double lowest_rate) {
    cases::Random random(seed);
    int clear = 0;
    for (int i = 0; i < 20000; ++i) {
        const Triangle triangle = cases::triangle(random);
        const Ray ray = cases::ray_at(cases::spot_on(triangle, random), 1.0, random);
        const Weights exact(triangle, ray);
        if (exact.parallel) continue;
        const dvec3 a(triangle.a), e1 = dvec3(triangle.b) - a, e2 = dvec3(triangle.c) - a;
        const dvec3 n = cross(e1, e2), d(ray.direction);
        const double rate = std::abs(dot(n, d)) / (taxicab(e1) * taxicab(e2) * taxicab(d));
        if (rate < lowest_rate) continue;
        const double distance = length(dvec3(ray.origin) - a) + 1;
        const double doubt = 32 * 0x1p-24 * distance * taxicab(e1) * taxicab(e2) / length(n) *
                             (length(n) * length(d) / std::abs(dot(n, d)));
        if (std::abs(exact.least()) < doubt * std::max(1 / length(e1), 1 / length(e2))) continue;
        ++clear;
        const Answer answer = ask(triangle, ray, test);
        ASSERT_EQ(answer.hit, exact.least() > 0)
            << cases::print(ray) << " weights " << exact.a << ' ' << exact.b << ' ' << exact.c;
    }
    EXPECT_GT(clear, 5000);
}

TEST(Triangle, clear_hits_and_misses_agree_with_rational_arithmetic) {
    expect_exact_decisions(11, ordinary, 0x1p-30);
}

/// What float puts outside is never asked again in double: it has to be outside.
TEST(Triangle, that_float_puts_outside_is_missed_in_rational_arithmetic) {
    cases::Random random(17);
    int outside = 0, barely = 0;
    for (int i = 0; i < 40000; ++i) {
        const Triangle triangle = cases::triangle(random);
        Ray ray = cases::ray_at(cases::spot_on(triangle, random), 1.0, random);
        ray.origin += random.in_cube(random.magnitude(-18, 0));  // past it, by much or by little
        const vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a;
        const TriangleSums<float> sums(triangle.a, e1, e2, ray.origin, ray.direction);
        const float apart = taxicab(ray.origin - triangle.a);
        if (!sums.outside(largest_sum(taxicab(e1) + taxicab(e2), apart, taxicab(ray.direction))))
            continue;
        ++outside;
        const Weights exact(triangle, ray);
        if (exact.parallel) continue;
        barely += exact.least() > -0x1p-10;
        ASSERT_LT(exact.least(), 0)
            << cases::print(ray) << " weights " << exact.a << ' ' << exact.b << ' ' << exact.c;
    }
    EXPECT_GT(outside, 2000);
    EXPECT_GT(barely, 100);
}

TEST(Triangle, clear_hits_and_misses_agree_with_rational_arithmetic_when_watertight) {
    expect_exact_decisions(12, watertight, 0x1p-16);
}

TEST(Triangle, reports_its_exact_parameter_and_weights_on_a_grid) {
    const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    Ray ray;
    ray.origin = {1, 2, 8};
    ray.direction = {0, 0, -2};
    for (const Answer& answer : {ask(triangle, ray, ordinary), ask(triangle, ray, watertight)}) {
        ASSERT_TRUE(answer.hit);
        EXPECT_EQ(answer.t, 4);
        EXPECT_EQ(answer.u, 0.25f);
        EXPECT_EQ(answer.v, 0.5f);
    }
}

TEST(Triangle, is_hit_from_both_sides_and_behind_the_origin) {
    const Triangle triangle{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    for (const float side : {-1.0f, 1.0f}) {
        for (const float sense : {-1.0f, 1.0f}) {
            Ray ray;
            ray.origin = {1, 1, side};
            ray.direction = {0, 0, sense};
            EXPECT_EQ(ask(triangle, ray, ordinary).t, -side * sense);
            EXPECT_EQ(ask(triangle, ray, watertight).t, -side * sense);
        }
    }
}

TEST(Triangle, without_area_is_never_hit) {
    cases::Random random(13);
    for (int i = 0; i < 2000; ++i) {
        const vec3 a = random.in_cube(1), b = random.in_cube(1);
        for (const Triangle& flat : {Triangle{a, a, a}, Triangle{a, b, b}, Triangle{a, b, a}}) {
            Ray ray;
            ray.origin = random.in_cube(4);
            ray.direction = a - ray.origin;
            EXPECT_FALSE(ask(flat, ray, ordinary).hit);
            EXPECT_FALSE(ask(flat, ray, watertight).hit);
        }
    }
}

/// A fan round a vertex: rays at its edges and at the vertex must meet one of the triangles.
TEST(Triangle, fans_are_closed_when_watertight) {
    cases::Random random(14);
    for (int i = 0; i < 2000; ++i) {
        const vec3 top = random.in_cube(0.1) + vec3(0, 0, 0.5f);
        std::array<vec3, 6> rim;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const std::array<std::array<float, 2>, 6> hexagon{
                {{2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}}};
            rim[k] = random.in_cube(0.2) + vec3(hexagon[k][0], hexagon[k][1], 0);
        }
        GeometryBuilder builder;
        for (std::size_t k = 0; k < rim.size(); ++k)
            builder.add_triangle(top, rim[k], rim[(k + 1) % rim.size()]);
        const Geometry geometry = std::move(builder).build(Precision::watertight);
        const double diagonal = cases::diagonal(geometry.bounds());
        for (int j = 0; j < 20; ++j) {
            const double share = j == 0 ? 0 : random.uniform(0, 0.9);
            const dvec3 target = dvec3(top) + share * (dvec3(rim[random.below(6)]) - dvec3(top));
            const dvec3 away = random.unit();
            if (std::abs(away.z) < 0.8) continue;  // seen from the side the fan has a silhouette
            Ray ray;
            ray.origin = vec3(target + random.uniform(0.1, 3.9) * diagonal * away);
            ray.direction = vec3(target - dvec3(ray.origin));
            Hit hit = nothing_yet(ray);
            Silent silent;
            for (std::uint32_t k = 0; k < geometry.size(); ++k)
                test_primitive<Query::closest>(geometry, k, ray, hit, silent);
            EXPECT_NE(hit.primitive, no_primitive) << cases::print(ray);
        }
    }
}

}  // namespace
}  // namespace rayshoot
