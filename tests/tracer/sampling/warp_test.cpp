#include "tracer/sampling/warp.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tests/tracer/sampling/chi_squared.h"
#include "tracer/random.h"

namespace rayshoot {
namespace {

constexpr double pi = std::numbers::pi;
using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
constexpr int samples = 200000;  // of each chi^2 test

Pair random_pair(std::uint32_t i) {
    const RandomSequence random(1, 0, i);
    return {random.number(0), random.number(1)};
}

/// Of an azimuth, in 16 parts of the circle.
std::size_t sector(double x, double y) {
    const double turns = std::atan2(y, x) / (2 * pi);
    return static_cast<std::size_t>((turns < 0 ? turns + 1 : turns) * 16) % 16;
}

/// Null hypothesis: the directions have the density `pdf` of z, per solid angle; 16 sectors of each
/// slice between two of `edges`, which ascend. Also that the density's integral is 1.
void expect_density(const std::function<vec3(Pair)>& direction,
                    const std::function<double(double)>& pdf, const std::vector<double>& edges) {
    const std::size_t slices = edges.size() - 1;
    std::vector<double> shares;
    double total = 0;
    for (std::size_t i = 0; i < slices; ++i) {
        shares.push_back(2 * pi * Quadrature::integrate(pdf, edges[i], edges[i + 1]));
        total += shares.back();
    }
    EXPECT_NEAR(total, 1, 1e-5);
    Histogram histogram(slices * 16);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const vec3 unit = direction(random_pair(i));
        ASSERT_NEAR(length(unit), 1, 2e-7);
        ASSERT_GE(unit.z, edges.front() - 1e-7);
        const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, double{unit.z});
        const auto slice = static_cast<std::size_t>(above - edges.begin() - 1);
        histogram.add(slice * 16 + sector(unit.x, unit.y));
    }
    EXPECT_TRUE(histogram.agrees([&](std::size_t bin) { return shares[bin / 16] / 16; }));
}

std::vector<double> even(double lo, double hi) {
    std::vector<double> edges;
    for (int i = 0; i <= 20; ++i) edges.push_back(lo + (hi - lo) * i / 20);
    return edges;
}

TEST(Warp, directions_of_the_sphere_are_uniform) {
    expect_density(
        uniform_sphere, [](double) { return uniform_sphere_pdf(); }, even(-1, 1));
}

TEST(Warp, directions_of_the_hemisphere_go_by_the_cosine) {
    expect_density(
        cosine_hemisphere, [](double z) { return cosine_hemisphere_pdf(static_cast<float>(z)); },
        even(0, 1));
    EXPECT_EQ(cosine_hemisphere_pdf(-0.5f), 0.0f);
}

TEST(Warp, directions_of_a_cone_are_uniform) {
    for (const double height : {2.0, 1.0, 0.25, 1e-3}) {
        expect_density([&](Pair pair) { return uniform_cone(pair, height); },
                       [&](double) { return uniform_cone_pdf(height); }, even(1 - height, 1));
    }
}

/// 10^-9 radians: 1 - cos would be 0.
TEST(Warp, narrow_cones_are_filled) {
    constexpr double sine = 1e-9;
    const double height = cap_height(sine * sine);
    EXPECT_NEAR(height, sine * sine / 2, 1e-30);
    EXPECT_EQ(cap_height(1), 1);
    Histogram histogram(64);  // by area, to first order
    for (std::uint32_t i = 0; i < samples; ++i) {
        const vec3 unit = uniform_cone(random_pair(i), height);
        const double squared = (double{unit.x} * unit.x + double{unit.y} * unit.y) / (sine * sine);
        ASSERT_LT(squared, 1 + 1e-6);
        histogram.add(std::min<std::size_t>(3, cell(static_cast<float>(squared), 4)) * 16 +
                      sector(unit.x, unit.y));
    }
    EXPECT_TRUE(histogram.uniform());
}

TEST(Warp, phong_lobes_have_their_density) {
    for (const float exponent : {0.f, 1.f, 2.5f, 30.f, 1000.f}) {
        std::vector<double> edges = even(0, 1);
        for (double& edge : edges) edge = std::pow(edge, 1 / (double{exponent} + 1));
        // In double: the float of a cosine near 1 is too coarse for the quadrature.
        const auto pdf = [&](double z) {
            return (double{exponent} + 1) / (2 * pi) * std::pow(z, double{exponent});
        };
        expect_density([&](Pair pair) { return phong_lobe(pair, exponent); }, pdf, edges);
        for (const float z : {0.1f, 0.5f, 0.9f, 1.f}) {
            EXPECT_FLOAT_EQ(phong_lobe_pdf(z, exponent), static_cast<float>(pdf(z)));
        }
        EXPECT_EQ(phong_lobe_pdf(-0.5f, exponent), 0.0f);
    }
}

/// Null hypothesis: uniform on the disc, 16 sectors of 16 rings of equal area.
TEST(Warp, the_disc_is_uniform) {
    Histogram histogram(256);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const glm::vec2 point = concentric_disc(random_pair(i));
        const float squared = point.x * point.x + point.y * point.y;
        ASSERT_LT(squared, 1.0f);
        histogram.add(cell(squared, 16) * 16 + sector(point.x, point.y));
    }
    EXPECT_TRUE(histogram.uniform());
    EXPECT_FLOAT_EQ(disc_pdf(), static_cast<float>(1 / pi));
}

/// Of the closed curve through the images of a square's boundary.
double mapped_area(float u, float v, float edge) {
    constexpr int steps = 256;
    std::vector<glm::dvec2> curve;
    const float directions[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (const auto& [du, dv] : directions) {
        for (int i = 0; i < steps; ++i) {
            curve.emplace_back(concentric_disc({u, v}));
            u += du * edge / steps;
            v += dv * edge / steps;
        }
    }
    double area = 0;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const glm::dvec2 a = curve[i], b = curve[(i + 1) % curve.size()];
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    return area;
}

TEST(Warp, the_concentric_map_preserves_areas) {
    for (float u = 0; u < 1; u += 0.125f) {
        for (float v = 0; v < 1; v += 0.125f) {
            EXPECT_NEAR(mapped_area(u, v, 0.125f), pi / 64, 1e-6);
        }
    }
}

TEST(Warp, the_concentric_map_is_as_published) {  // Shirley & Chiu 1997: r = a, phi = pi/4 b/a
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const Pair pair = random_pair(i);
        const double a = 2 * double{pair.u} - 1, b = 2 * double{pair.v} - 1;
        const bool wide = std::abs(a) > std::abs(b);
        const double r = wide ? a : b, phi = wide ? pi / 4 * b / a : pi / 2 - pi / 4 * a / b;
        const glm::vec2 point = concentric_disc(pair);
        EXPECT_NEAR(point.x, r * std::cos(phi), 2e-7);
        EXPECT_NEAR(point.y, r * std::sin(phi), 2e-7);
    }
}

TEST(Warp, corners_of_the_square_stay_inside) {
    constexpr float last = 1 - 0x1p-24f;
    for (const Pair pair : {Pair{0, 0}, {0, last}, {last, 0}, {last, last}, {0.5f, 0.5f}}) {
        EXPECT_GT(cosine_hemisphere(pair).z, 0.0f);
        EXPECT_NEAR(length(uniform_sphere(pair)), 1, 1e-7);
        EXPECT_GE(phong_lobe(pair, 0).z, 0.0f);
        const Pair weights = uniform_triangle(pair);
        EXPECT_LE(weights.u + weights.v, 1.0f);
    }
}

/// Null hypothesis: uniform on the triangle, 64 congruent parts.
TEST(Warp, the_triangle_is_uniform) {
    Histogram histogram(128);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const auto [u, v] = uniform_triangle(random_pair(i));
        const bool upper = 8 * u - std::floor(8 * u) + 8 * v - std::floor(8 * v) > 1;
        histogram.add((cell(v, 8) * 8 + cell(u, 8)) * 2 + upper);
    }
    EXPECT_TRUE(histogram.agrees([](std::size_t bin) {
        const std::size_t sum = bin / 16 + bin / 2 % 8;
        return sum < 7 || (sum == 7 && bin % 2 == 0) ? 1.0 / 64 : 0;
    }));
}

/// Null hypothesis: uniform on the polygon: 16 rings of equal area in each of its triangles, cut
/// into 8 across. A point's ring and place are told from its distance to the edge.
TEST(Warp, polygons_are_uniform) {
    for (const int blades : {3, 5, 6, 8}) {
        constexpr float angle = 0.3f;
        const double half = pi / blades;  // half the angle that an edge is seen under
        const auto edges = static_cast<std::size_t>(blades);
        Histogram histogram(edges * 128);
        for (std::uint32_t i = 0; i < samples; ++i) {
            const glm::dvec2 point = regular_polygon(random_pair(i), blades, angle);
            double turn = std::atan2(point.y, point.x) - angle;
            turn -= 2 * pi * std::floor(turn / (2 * pi));
            const std::size_t edge =
                std::min(static_cast<std::size_t>(turn / (2 * half)), edges - 1);
            const double off_middle = turn - (2 * static_cast<double>(edge) + 1) * half;
            const double outwards = length(vec3(point, 0)) * std::cos(off_middle) / std::cos(half);
            const double across = (std::tan(off_middle) / std::tan(half) + 1) / 2;
            ASSERT_LT(outwards, 1 + 1e-6);
            const auto ring =
                std::min<std::size_t>(15, static_cast<std::size_t>(outwards * outwards * 16));
            const auto part = static_cast<std::size_t>(std::clamp(across, 0.0, 0.999) * 8);
            histogram.add((edge * 16 + ring) * 8 + part);
        }
        EXPECT_TRUE(histogram.uniform()) << blades;
        const double area = blades * std::sin(half) * std::cos(half);
        EXPECT_FLOAT_EQ(regular_polygon_pdf(blades), static_cast<float>(1 / area));
    }
}

TEST(Warp, polygons_begin_at_their_angle) {
    constexpr float last = 1 - 0x1p-24f;
    const glm::vec2 corner = regular_polygon({0, last}, 5, 0.3f);
    EXPECT_NEAR(corner.x, std::cos(0.3), 1e-6);
    EXPECT_NEAR(corner.y, std::sin(0.3), 1e-6);
}

}  // namespace
}  // namespace rayshoot
