#include "tracer/sampling/warp.h"

#include <cmath>
#include <numbers>

namespace rayshoot {
namespace {

constexpr double pi = std::numbers::pi;

struct OnCircle {
    double cosine, sine;
};

/// Of an angle in [-pi/4, pi/4], by their power series, 1 / n! each, with an error below 10^-12.
/// Not std::cos: C libraries differ in the last bit, and in the time they take.
OnCircle within_eighth(double angle) {
    constexpr double c2 = -1. / 2, c4 = 1. / 24, c6 = -1. / 720, c8 = 1. / 40320,
                     c10 = -1. / 3628800, c12 = 1. / 479001600;
    constexpr double s3 = -1. / 6, s5 = 1. / 120, s7 = -1. / 5040, s9 = 1. / 362880,
                     s11 = -1. / 39916800, s13 = 1. / 6227020800;
    const double s = angle * angle;
    const double cosine = 1 + s * (c2 + s * (c4 + s * (c6 + s * (c8 + s * (c10 + s * c12)))));
    const double sine = 1 + s * (s3 + s * (s5 + s * (s7 + s * (s9 + s * (s11 + s * s13)))));
    return {cosine, angle * sine};
}

/// Of `turns` of 2 pi each; a few, so that they are exact.
OnCircle on_circle(double turns) {
    const int quarter = static_cast<int>(std::floor(4 * turns + 0.5));
    const auto [cosine, sine] = within_eighth((turns - 0.25 * quarter) * (2 * pi));
    // By choices, not jumps, which random angles would have predicted wrong.
    const double sign = 1 - (quarter & 2);
    return {sign * (quarter & 1 ? -sine : cosine), sign * (quarter & 1 ? cosine : sine)};
}

struct OnDisc {
    double x, y;
};

/// From [0, 1) to (-1, 1), alike for both signs: a number stands for the middle of its multiple of
/// 2^-24. So the disc's edge, a horizontal direction of density 0, is never met.
double centred(float u) { return 2 * double{u} - 1 + 0x1p-24; }

OnDisc disc(Pair pair) {
    const double a = centred(pair.u), b = centred(pair.v);
    const bool steep = std::abs(b) > std::abs(a);
    const double radius = steep ? b : a;  // of the square; signed, so two quarters are one
    const double across = steep ? a : b;
    if (radius == 0) return {0, 0};
    const auto [cosine, sine] = within_eighth(pi / 4 * (across / radius));
    return {radius * (steep ? sine : cosine), radius * (steep ? cosine : sine)};
}

/// With z, and an azimuth of `turns` of 2 pi; `sine` is the distance from the axis.
vec3 direction(double sine, double z, double turns) {
    const OnCircle azimuth = on_circle(turns);
    return vec3(dvec3(sine * azimuth.cosine, sine * azimuth.sine, z));
}

}  // namespace

glm::vec2 concentric_disc(Pair pair) {
    const OnDisc point = disc(pair);
    return {static_cast<float>(point.x), static_cast<float>(point.y)};
}

float disc_pdf() { return static_cast<float>(1 / pi); }

glm::vec2 regular_polygon(Pair pair, int blades, float angle) {
    // A triangle of the centre and two corners for each blade; u tells which, and where across it.
    const double corner = std::floor(double{pair.u} * blades);
    const double across = double{pair.u} * blades - corner;
    const double outwards = std::sqrt(double{pair.v});
    const double turns = angle / (2 * pi) + corner / blades;
    const OnCircle from = on_circle(turns), to = on_circle(turns + 1.0 / blades);
    const double x = (1 - across) * from.cosine + across * to.cosine;
    const double y = (1 - across) * from.sine + across * to.sine;
    return {static_cast<float>(outwards * x), static_cast<float>(outwards * y)};
}

float regular_polygon_pdf(int blades) {
    return static_cast<float>(2 / (blades * std::sin(2 * pi / blades)));
}

vec3 cosine_hemisphere(Pair pair) {
    const auto [x, y] = disc(pair);
    return vec3(dvec3(x, y, std::sqrt(1 - (x * x + y * y))));
}

float cosine_hemisphere_pdf(float cosine) {
    return cosine > 0 ? static_cast<float>(cosine / pi) : 0;
}

vec3 uniform_sphere(Pair pair) { return uniform_cone(pair, 2); }

float uniform_sphere_pdf() { return uniform_cone_pdf(2); }

double cap_height(double sine_squared) { return sine_squared / (1 + std::sqrt(1 - sine_squared)); }

vec3 uniform_cone(Pair pair, double height) {
    const double down = pair.u * height;  // 1 - cos
    return direction(std::sqrt(down * (2 - down)), 1 - down, pair.v);
}

float uniform_cone_pdf(double height) { return static_cast<float>(1 / (2 * pi * height)); }

Pair uniform_triangle(Pair pair) {
    const float u = pair.u, v = pair.v;
    return v > u ? Pair{u / 2, v - u / 2} : Pair{u - v / 2, v / 2};
}

vec3 phong_lobe(Pair pair, float exponent) {
    const double cosine = std::pow(1 - double{pair.u}, 1 / (double{exponent} + 1));
    return direction(std::sqrt(1 - cosine * cosine), cosine, pair.v);
}

float phong_lobe_pdf(float cosine, float exponent) {
    if (!(cosine > 0)) return 0;
    const double n = exponent;
    return static_cast<float>((n + 1) / (2 * pi) * std::pow(double{cosine}, n));
}

}  // namespace rayshoot
