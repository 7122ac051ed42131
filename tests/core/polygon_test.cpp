#include <gtest/gtest.h>

#include "accel/core/primitive/polygon.h"
#include "tests/core/cases.h"
#include "tests/core/truth.h"

namespace rayshoot {
namespace {

std::optional<float> ask(const Polygon& polygon, const vec3& origin, const vec3& direction) {
    return crossing(polygon, origin, direction);
}

/// A gear: 12 teeth, concave, in the plane z = 1.
Polygon gear() {
    std::vector<vec3> corners;
    dvec3 turn(1, 0, 0);
    constexpr double t = 0.0654, c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    for (int i = 0; i < 48; ++i) {
        const double radius = i % 4 < 2 ? 1 : 0.8;
        corners.push_back(vec3(dvec3(radius * turn.x, radius * turn.y, 1)));
        turn = {c * turn.x - s * turn.y, s * turn.x + c * turn.y, 0};
    }
    return make_polygon(corners, {});
}

TEST(Polygon, clear_hits_and_misses_agree_with_high_precision) {
    cases::Random random(41);
    int hits = 0, found_hits = 0, misses = 0;
    for (int i = 0; i < 50000; ++i) {
        const Polygon polygon = cases::polygon(random);
        const Ray ray = cases::ray_at(cases::spot_on(polygon, random), 2, random);
        const truth::Point n(polygon.normal), d(ray.direction);
        const truth::Point from = truth::Point(ray.origin) - truth::Point(polygon.centre);
        const truth::Real rate = truth::dot(n, d);
        const double sine = static_cast<double>(abs(rate) / (length(n) * length(d)));
        if (sine < 1e-4) continue;
        const truth::Real t = -truth::dot(n, from) / rate;
        const truth::Point p = truth::Point(ray.origin) + t * d;
        const double off = static_cast<double>(truth::distance(p, polygon));
        const auto found = ask(polygon, ray.origin, ray.direction);
        if (off < 1e-25) {
            ++hits;
            const double doubt = 1e-9 / sine / length(dvec3(ray.direction));
            if (!found) continue;  // counted below: an edge as near as rounding from a far origin
            ++found_hits;
            ASSERT_NEAR(*found, static_cast<double>(t),
                        0x1p-23 * std::abs(static_cast<double>(t)) + doubt);
        } else if (off > 1e-8) {
            ++misses;
            ASSERT_FALSE(found) << cases::print(ray) << " off by " << off;
        }
    }
    EXPECT_GT(hits, 20000);
    EXPECT_GE(found_hits, hits - hits / 1000);
    EXPECT_GT(misses, 1000);
}

TEST(Polygon, gear_is_hit_in_its_teeth_and_missed_between_them) {
    const Polygon polygon = gear();
    int inside = 0, outside = 0;
    cases::Random random(42);
    for (int i = 0; i < 20000; ++i) {
        const vec3 target(dvec3(random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1), 1));
        const double radius = length(dvec3(target.x, target.y, 0));
        const auto t = ask(polygon, target + vec3(0, 0, 2), {0, 0, -1});
        if (radius < 0.78) {
            EXPECT_EQ(t, 2.0f);
        }
        if (radius > 1) {
            EXPECT_FALSE(t);
        }
        if (radius > 0.81 && radius < 0.98) ++(t ? inside : outside);
    }
    // Teeth and gaps share the ring about evenly.
    EXPECT_GT(inside, 1500);
    EXPECT_GT(outside, 1500);
}

/// Cells of one plane cut by shared edges: every ray meets exactly one of them.
TEST(Polygon, neighbours_in_one_plane_share_no_point_and_leave_no_gap) {
    std::vector<Polygon> cells;
    for (int x = 0; x < 4; ++x) {
        for (int y = 0; y < 4; ++y) {
            const float lo_x = 0.25f * float(x), lo_y = 0.25f * float(y);
            const std::array<vec3, 4> corners{
                vec3(lo_x, lo_y, 0.5f), vec3(lo_x + 0.25f, lo_y, 0.5f),
                vec3(lo_x + 0.25f, lo_y + 0.25f, 0.5f), vec3(lo_x, lo_y + 0.25f, 0.5f)};
            cells.push_back(make_polygon(corners, {}));
        }
    }
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            int hits = 0;
            for (const Polygon& cell : cells)
                hits += ask(cell, {float(i) / 64, float(j) / 64, 3}, {0, 0, -1}).has_value();
            EXPECT_EQ(hits, 1) << i << ' ' << j;
        }
    }
}

TEST(Polygon, rays_in_its_plane_miss) {
    const Polygon polygon = gear();
    EXPECT_FALSE(ask(polygon, {-3, 0, 1}, {1, 0, 0}));
    EXPECT_FALSE(ask(polygon, {-3, 0.1f, 1}, {1e20f, 1e19f, 0}));
}

TEST(Polygon, without_area_is_never_hit) {
    cases::Random random(43);
    for (int i = 0; i < 2000; ++i) {
        const vec3 a = random.in_cube(1), step(0.25f, -0.5f, 0.125f);
        const Polygon line = make_polygon(std::array<vec3, 4>{a, a + step, a + 2.0f * step, a}, {});
        const Polygon point = make_polygon(std::array<vec3, 4>{a, a, a, a}, {});
        const vec3 origin = random.in_cube(3);
        EXPECT_FALSE(ask(point, origin, a - origin));
        if (line.normal == dvec3(0)) {
            EXPECT_FALSE(ask(line, origin, a - origin));
        }
    }
}

TEST(Polygon, is_met_at_every_scale) {
    for (const float s : {1e-36f, 1e-20f, 1e-6f, 1.0f, 1e6f, 1e20f, 1e36f}) {
        const std::array<vec3, 4> corners{vec3(0), vec3(s, 0, 0), vec3(s, s, s), vec3(0, s, s)};
        const auto t = ask(make_polygon(corners, {}), {0.5f * s, 0.5f * s, 2 * s}, {0, 0, -s});
        ASSERT_TRUE(t) << s;
        EXPECT_FLOAT_EQ(*t, 1.5f);
    }
}

TEST(Polygon, too_few_corners_or_unmatched_normals_are_refused) {
    const std::array<vec3, 4> corners{vec3(0), vec3(1, 0, 0), vec3(1, 1, 0), vec3(0, 1, 0)};
    const std::array<vec3, 3> normals{};
    EXPECT_THROW(make_polygon(std::span(corners).first(2), {}), std::invalid_argument);
    EXPECT_THROW(make_polygon(corners, normals), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
