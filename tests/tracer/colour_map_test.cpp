#include "tracer/colour_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tracer/colour_bar.h"

namespace rayshoot {
namespace {

constexpr int steps = 255;

vec3 colour(int step) { return map_colour(static_cast<double>(step) / steps); }

/// Rec. 709: relative luminance, of which CIE's lightness is a monotone function. Knows nothing of
/// OKLab, in which the map was made.
double luminance(const vec3& linear) {
    return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

/// CIE 1976: L*, 0 to 100.
double lightness(const vec3& linear) {
    const double y = luminance(linear);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

/// Ottosson 2020: linear sRGB to OKLab.
dvec3 oklab(const vec3& c) {
    const double l = std::cbrt(0.4122214708 * c.x + 0.5363325363 * c.y + 0.0514459929 * c.z);
    const double m = std::cbrt(0.2119034982 * c.x + 0.6806995451 * c.y + 0.1073969566 * c.z);
    const double s = std::cbrt(0.0883024619 * c.x + 0.2817188376 * c.y + 0.6299787005 * c.z);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

TEST(ColourMap, lightness_rises_at_every_step_and_nearly_evenly) {
    const double rise = lightness(colour(steps)) - lightness(colour(0));
    EXPECT_GT(rise, 70);
    for (int step = 1; step <= steps; ++step) {
        const double change = lightness(colour(step)) - lightness(colour(step - 1));
        EXPECT_GT(change, 0.6 * rise / steps) << step;
        EXPECT_LT(change, 1.5 * rise / steps) << step;
    }
}

TEST(ColourMap, equal_steps_are_equally_far_apart_in_oklab) {
    const double mean = length(oklab(colour(1)) - oklab(colour(0)));
    for (int step = 1; step <= steps; ++step) {
        const double apart = length(oklab(colour(step)) - oklab(colour(step - 1)));
        EXPECT_NEAR(apart, mean, 0.005 * mean) << step;
    }
}

TEST(ColourMap, every_colour_can_be_shown) {
    for (int step = 0; step <= 10 * steps; ++step) {
        const vec3 c = map_colour(step / (10.0 * steps));
        for (int channel = 0; channel < 3; ++channel) {
            EXPECT_GE(c[channel], 0) << step;
            EXPECT_LE(c[channel], 1) << step;
        }
    }
}

TEST(ColourMap, goes_no_further_than_its_ends_and_shows_no_number_as_grey) {
    EXPECT_EQ(map_colour(-3), map_colour(0));
    EXPECT_EQ(map_colour(std::numeric_limits<double>::infinity()), map_colour(1));
    const vec3 none = map_colour(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(none.x, none.y);
    EXPECT_EQ(none.y, none.z);
}

TEST(ColourScale, place_and_value_are_inverse) {
    for (const Spacing spacing : {Spacing::linear, Spacing::logarithmic}) {
        const ColourScale scale{2, 900, spacing};
        EXPECT_EQ(scale.place(2), 0);
        EXPECT_EQ(scale.place(900), 1);
        for (const double value : {2.0, 3.5, 100.0, 899.0})
            EXPECT_NEAR(scale.value(scale.place(value)), value, 1e-9 * value);
    }
    EXPECT_EQ((ColourScale{0, 10}).place(5), 0.5);
    EXPECT_NEAR((ColourScale{0, 99, Spacing::logarithmic}).place(9), 0.5, 1e-15);
}

TEST(ColourScale, of_no_length_is_its_low_end) {
    EXPECT_EQ((ColourScale{0, 0}).place(0), 0);
    EXPECT_EQ((ColourScale{0, 0, Spacing::logarithmic}).place(7), 0);
}

TEST(ColourScale, is_one_for_all_images) {
    std::vector<ScalarImage> images{ScalarImage(2, 1, 3), ScalarImage(1, 1, 7)};
    images[0].at(1, 0) = std::numeric_limits<double>::infinity();
    const ColourScale scale = common_scale(images, Spacing::linear);
    EXPECT_EQ(scale.low, 0);
    EXPECT_EQ(scale.high, 7);
    EXPECT_EQ(coloured(images[0], scale).at(0, 0), map_colour(3.0 / 7));
    EXPECT_EQ(coloured(images[1], scale).at(0, 0), map_colour(1));
}

TEST(ColourBar, shows_the_map_from_left_to_right_over_its_labels) {
    const Image bar = colour_bar({0, 1000}, 300);
    EXPECT_EQ(bar.width(), 300);
    for (int x = 0; x < 300; ++x) EXPECT_EQ(bar.at(x, 0), map_colour((x + 0.5) / 300)) << x;
    int black = 0, ticks = 0;
    constexpr int below_bar = 24, below_ticks = 32;
    for (int x = 0; x < 300; ++x) {
        ticks += bar.at(x, below_bar) == vec3(0);
        for (int y = below_ticks; y < bar.height(); ++y) black += bar.at(x, y) == vec3(0);
    }
    EXPECT_GE(ticks, 3);
    EXPECT_GT(black, 100);
}

TEST(ColourBar, has_room_for_its_longest_labels_when_narrow) {
    const Image bar = colour_bar({0, 1.23e100}, 1);
    EXPECT_GE(bar.width(), 64);
}

}  // namespace
}  // namespace rayshoot
