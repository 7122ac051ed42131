#include "tracer/filter/regions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/tracer/filter/filters.h"

namespace rayshoot {
namespace {

constexpr std::array discs{FilterKind::cone, FilterKind::raised_cosine, FilterKind::gaussian};

void expect_radii(FilterKind kind, const std::vector<double>& wanted) {
    const std::vector<double> radii = equal_volume_radii(kind, static_cast<int>(wanted.size()));
    ASSERT_EQ(radii.size(), wanted.size());
    for (std::size_t i = 0; i < radii.size(); ++i) EXPECT_NEAR(radii[i], wanted[i], 5e-7) << i;
}

/// The textbook's exercise.
TEST(Regions, four_annuli_of_the_raised_cosine) {
    expect_radii(FilterKind::raised_cosine, {0.286936, 0.433572, 0.585817, 1});
}

TEST(Regions, other_numbers_of_annuli) {
    expect_radii(FilterKind::raised_cosine, {1});
    expect_radii(FilterKind::raised_cosine, {0.433572, 1});
    expect_radii(FilterKind::raised_cosine, {0.337993, 0.531437, 1});
    expect_radii(FilterKind::raised_cosine, {0.253795, 0.376731, 0.491204, 0.622081, 1});
    expect_radii(FilterKind::raised_cosine,
                 {0.197502, 0.286936, 0.362344, 0.433572, 0.506051, 0.585817, 0.685918, 1});
    expect_radii(FilterKind::cone, {0.326352, 0.5, 0.673648, 1});
}

TEST(Regions, the_raised_cosine_is_normalised) {
    EXPECT_NEAR(raised_cosine_normalisation(1), 0.5352307, 5e-8);
    EXPECT_NEAR(raised_cosine_normalisation(1.5), 0.237880, 5e-7);
    EXPECT_NEAR(raised_cosine_normalisation(1.7), 0.185201, 5e-7);
    EXPECT_NEAR(raised_cosine_normalisation(2), 0.133808, 5e-7);
    for (const double radius : {0.5, 1.5, 1.7, 2.0}) {
        // w(0) is 1 here, and 2 k there.
        const Filter filter({FilterKind::raised_cosine, radius});
        EXPECT_NEAR(2 * raised_cosine_normalisation(radius) * filter.integral(), 1, 1e-14);
    }
}

double volume(const Filter& filter, const Region& region) {
    const double ring = filter_tests::integral(region.inner, region.outer, filter.reach(),
                                               [&](double r) { return r * filter.profile(r); });
    return ring * (region.to - region.from);
}

TEST(Regions, volumes_are_equal) {
    for (const FilterKind kind : discs) {
        const Filter filter({kind, 1.7});
        const std::vector<Region> regions = equal_volume_regions(filter, 4, 4);
        ASSERT_EQ(regions.size(), 16u);
        for (const Region& region : regions) {
            EXPECT_NEAR(16 * volume(filter, region) / filter.integral(), 1, 1e-12) << name(kind);
        }
    }
}

TEST(Regions, areas_are_equal) {
    for (const Region& region : equal_area_regions(Filter({FilterKind::cone, 1.7}), 5, 3)) {
        const double area = (region.outer * region.outer - region.inner * region.inner) / 2 *
                            (region.to - region.from);
        EXPECT_NEAR(15 * area / (std::numbers::pi * 1.7 * 1.7), 1, 1e-14);
    }
}

bool contains(const Region& region, const Filter::Offset& offset) {
    const double r = std::hypot(offset.x, offset.y);
    double azimuth = std::atan2(offset.y, offset.x);
    if (azimuth < 0) azimuth += 2 * std::numbers::pi;
    constexpr double rounding = 1e-12;
    return r >= region.inner - rounding && r < region.outer + rounding &&
           azimuth >= region.from - rounding && azimuth < region.to + rounding;
}

/// A stratified sampler takes one sample from within each region.
TEST(Regions, strata_of_pairs_are_regions) {
    constexpr int annuli = 4, sectors = 5, steps = 7;
    for (const FilterKind kind : discs) {
        const Filter filter({kind, 2});
        const auto volumes = equal_volume_regions(filter, annuli, sectors);
        const auto areas = equal_area_regions(filter, annuli, sectors);
        for (int u = 0; u < annuli * steps; ++u) {
            for (int v = 0; v < sectors * steps; ++v) {
                const Pair pair{(static_cast<float>(u) + 0.5f) / (annuli * steps),
                                (static_cast<float>(v) + 0.5f) / (sectors * steps)};
                const auto index = static_cast<std::size_t>(u / steps * sectors + v / steps);
                EXPECT_TRUE(contains(volumes[index], filter.importance(pair)));
                EXPECT_TRUE(contains(areas[index], filter.uniform(pair)));
            }
        }
    }
}

TEST(Regions, squares_and_empty_cuts_are_refused) {
    EXPECT_THROW(equal_volume_radii(FilterKind::box, 4), std::invalid_argument);
    EXPECT_THROW(equal_volume_radii(FilterKind::cone, 0), std::invalid_argument);
    EXPECT_THROW(equal_area_regions(Filter({FilterKind::mitchell, 2}), 4, 4),
                 std::invalid_argument);
    EXPECT_THROW(equal_volume_regions(Filter({FilterKind::cone, 2}), 4, 0), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
