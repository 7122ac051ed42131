#include <gtest/gtest.h>

#include "accel/core/leaves.h"
#include "tests/core/motions.h"
#include "tests/core/truth.h"

/// Geometry::error_radius against 10^5 adversarial rays per kind: never exceeded, and not so large
/// that it says nothing.
namespace rayshoot {
namespace {

constexpr int shapes = 1000, rays_per_shape = 150;

/// Distances as shares of the error radius.
struct Worst {
    double reported = 0;  ///< of the points as the primitive tests report them
    double clamped = 0;   ///< of the points after the clamp to the primitive's bounds
    long hits = 0;
    long strayed = 0;  ///< hits that the clamp would have taken too far
};

/// By the line, in 113-bit arithmetic.
template <class Shape>
void expect_missed(const Ray& ray, const Shape& shape) {
    if constexpr (requires { truth::meetings(ray, shape); })
        EXPECT_TRUE(truth::meetings(ray, shape).empty()) << cases::print(ray);
    else ADD_FAILURE() << "strays, but never should: " << cases::print(ray);
}

float reach_of(const Geometry& geometry, const Ray& ray) {
    const Box& box = geometry.bounds();
    const dvec3 centre = 0.5 * (dvec3(box.lo) + dvec3(box.hi));
    return static_cast<float>(length(dvec3(ray.origin) - centre) * (1 + 1e-6));
}

template <class Shape, class Test>
void measure(const Shape& shape, const Geometry& geometry, const Ray& ray, Test&& test,
             Worst& worst) {
    const TestRay prepared(ray, geometry.precision());
    const double radius = geometry.error_radius(reach_of(geometry, ray));
    test(shape, prepared, [&](float t, float, float, auto&& strays) {
        if (!std::isfinite(t)) return;
        ++worst.hits;
        const double share =
            static_cast<double>(truth::distance(truth::point_at(ray, t), shape)) / radius;
        worst.reported = std::max(worst.reported, share);
        EXPECT_LE(share, 1) << cases::print(ray) << " t " << t;
        const Interval interval = clip(prepared, geometry.bounds(0));
        if (interval.empty()) return;
        const float clamped = interval.clamp(t);
        if (clamped == t) return;
        if (strays(clamped)) {
            ++worst.strayed;
            expect_missed(ray, shape);
            return;
        }
        const double after =
            static_cast<double>(truth::distance(truth::point_at(ray, clamped), shape)) / radius;
        worst.clamped = std::max(worst.clamped, after);
        EXPECT_LE(after, 1) << cases::print(ray) << " t " << t << " clamped to " << clamped;
    });
}

/// Rays to spots on the shape: from near and far, steep and grazing.
constexpr auto at_spots = [](const auto& shape, double size, cases::Random& random) {
    return cases::ray_at(cases::spot_on(shape, random), size, random);
};
/// Rays that pass an end of the shape by a rounding, nearly along a face of its bounds, from at
/// most 2^`farthest` sizes away.
template <int farthest>
constexpr auto past_ends = [](const auto& shape, double size, cases::Random& random) {
    return cases::ray_past_an_end(shape, size, farthest, random);
};

template <class Make, class Aim, class Test>
Worst measure_all(std::uint64_t seed, Make&& make, Aim&& aim, Test&& test,
                  Precision precision = Precision::standard) {
    cases::Random random(seed);
    Worst worst;
    for (int i = 0; i < shapes; ++i) {
        const auto shape = make(random);
        Geometry geometry;
        if constexpr (requires { cases::alone(shape, precision); })
            geometry = cases::alone(shape, precision);
        else geometry = cases::alone(shape);
        const double size = cases::diagonal(geometry.bounds());
        for (int j = 0; j < rays_per_shape; ++j)
            measure(shape, geometry, aim(shape, size, random), test, worst);
    }
    return worst;
}

constexpr auto ordinary = [](const auto& shape, const TestRay& ray, auto&& report) {
    meet(shape, ray, report);
};
constexpr auto watertight = [](const Triangle& triangle, const TestRay& ray, auto&& report) {
    meet_watertight(triangle, ray, report);
};

/// Enough hits, and a radius that many times smaller would be exceeded by some.
void expect_telling(const Worst& worst, double times) {
    EXPECT_GE(worst.hits, 100000);
    EXPECT_GT(worst.reported, 1 / times);
    testing::Test::RecordProperty("worst_share", std::to_string(worst.reported));
    testing::Test::RecordProperty("worst_share_after_clamping", std::to_string(worst.clamped));
}

TEST(ErrorRadius, holds_for_triangles_and_is_exceeded_128_times_smaller) {
    expect_telling(measure_all(1, cases::triangle, at_spots, ordinary), 128);
}
TEST(ErrorRadius, holds_for_watertight_triangles_and_is_exceeded_16_times_smaller) {
    expect_telling(measure_all(2, cases::triangle, at_spots, watertight, Precision::watertight),
                   16);
}
TEST(ErrorRadius, holds_for_spheres_and_is_exceeded_16_times_smaller) {
    expect_telling(measure_all(3, cases::sphere, at_spots, ordinary), 16);
}
TEST(ErrorRadius, holds_for_frusta_and_is_exceeded_8_times_smaller) {
    expect_telling(measure_all(4, cases::frustum, at_spots, ordinary), 8);
}
TEST(ErrorRadius, holds_for_polygons_and_is_exceeded_8_times_smaller) {
    expect_telling(measure_all(5, cases::polygon, at_spots, ordinary), 8);
}

/// Rays that miss, but are reported, and would be clamped along a face of the bounds.
TEST(ErrorRadius, holds_for_triangles_that_rays_pass_by_a_rounding) {
    const Worst worst = measure_all(7, cases::triangle, past_ends<16>, ordinary);
    EXPECT_GT(worst.strayed, 0);
    RecordProperty("strayed", std::to_string(worst.strayed));
}
TEST(ErrorRadius, holds_for_watertight_triangles_that_rays_pass_by_a_rounding) {
    EXPECT_GE(measure_all(8, cases::triangle, past_ends<2>, watertight, Precision::watertight).hits,
              1000);
}
TEST(ErrorRadius, holds_for_spheres_that_rays_pass_by_a_rounding) {
    EXPECT_GE(measure_all(9, cases::sphere, past_ends<16>, ordinary).hits, 5000);
}
TEST(ErrorRadius, holds_for_frusta_that_rays_pass_by_a_rounding) {
    EXPECT_GE(measure_all(10, cases::frustum, past_ends<16>, ordinary).hits, 5000);
}
TEST(ErrorRadius, holds_for_polygons_that_rays_pass_by_a_rounding) {
    EXPECT_GE(measure_all(11, cases::polygon, past_ends<16>, ordinary).hits, 5000);
}

/// Polygons in motion: their own error is small beside that of moving the ray.
TEST(ErrorRadius, holds_for_movers_and_is_exceeded_32_times_smaller) {
    cases::Random random(6);
    Worst worst;
    for (int i = 0; i < 50000; ++i) {
        const Motion motion = cases::motion(random);
        const Polygon shape = cases::polygon(random);
        GeometryBuilder builder;
        builder.add_polygon(shape.corners, {}, builder.add_motion(motion));
        const Geometry geometry = std::move(builder).build();
        Ray ray = cases::ray_at(cases::spot_on(shape, random), 2, random);
        ray.time = static_cast<float>(random.uniform(0, 1));
        // The same ray where the polygon is at that time.
        ray.origin = vec3(cases::moved(motion, ray.time, dvec3(ray.origin)));
        const dvec3 pivot(motion.pivot);
        ray.direction = vec3(cases::moved(motion, ray.time, pivot + dvec3(ray.direction)) -
                             cases::moved(motion, ray.time, pivot));
        const double radius = geometry.error_radius(reach_of(geometry, ray));
        intersect(shape, TestRay(into_rest_frame(motion, ray), Precision::standard),
                  [&](float t, float, float) {
                      if (!std::isfinite(t)) return;
                      ++worst.hits;
                      const dvec3 there = dvec3(ray.origin) + double(t) * dvec3(ray.direction);
                      const truth::Point at_rest(cases::moved_back(motion, ray.time, there));
                      const double share =
                          static_cast<double>(truth::distance(at_rest, shape)) / radius;
                      worst.reported = std::max(worst.reported, share);
                      EXPECT_LE(share, 1) << cases::print(ray) << " t " << t;
                  });
    }
    EXPECT_GE(worst.hits, 20000);
    EXPECT_GT(worst.reported, 1.0 / 32);
    RecordProperty("worst_share", std::to_string(worst.reported));
}

}  // namespace
}  // namespace rayshoot
