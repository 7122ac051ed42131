#include "tracer/image_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rayshoot {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();

TEST(ImageDifference, of_an_image_with_itself_is_nothing) {
    Image image(3, 2);
    image.at(1, 1) = {nan, endless, -endless};
    image.at(2, 0) = {1, -2, 0.0f};
    const ImageDifference same = compare_images(image, image);
    EXPECT_TRUE(same.agree());
    EXPECT_EQ(same.pixels, 6u);
    EXPECT_EQ(same.incomparable, 0u);
    EXPECT_EQ(same.largest, 0);
    EXPECT_EQ(same.rms, 0);
}

TEST(ImageDifference, is_counted_by_pixel_and_averaged_by_channel) {
    Image a(2, 2), b(2, 2);
    b.at(1, 0) = {3, 0, -4};
    b.at(0, 1) = {0, 0.5f, 0};
    const ImageDifference apart = compare_images(a, b);
    EXPECT_EQ(apart.differing, 2u);
    EXPECT_EQ(apart.largest, 4);
    EXPECT_EQ(apart.largest_at, (Pixel{1, 0}));
    EXPECT_NEAR(apart.rms, std::sqrt((9 + 16 + 0.25) / 12), 1e-15);
    EXPECT_FALSE(apart.agree());
}

TEST(ImageDifference, below_the_tolerance_no_pixel_differs) {
    Image a(2, 1), b(2, 1);
    b.at(0, 0).y = 0.25f;
    EXPECT_EQ(compare_images(a, b, 0.25).differing, 0u);
    EXPECT_EQ(compare_images(a, b, 0.2499).differing, 1u);
    EXPECT_EQ(compare_images(a, b, 0.25).largest, 0.25);
    b.at(0, 0).y = -0.0f;
    EXPECT_TRUE(compare_images(a, b).agree());
    b.at(0, 0).y = std::numeric_limits<float>::denorm_min();
    EXPECT_FALSE(compare_images(a, b).agree());
}

TEST(ImageDifference, a_number_against_none_differs_at_any_tolerance_and_has_no_size) {
    Image a(3, 1), b(3, 1);
    a.at(0, 0).x = nan;
    a.at(1, 0) = {0, endless, 0};
    b.at(1, 0) = {0, -endless, 2};
    const ImageDifference apart = compare_images(a, b, 1e30);
    EXPECT_EQ(apart.differing, 2u);
    EXPECT_EQ(apart.incomparable, 2u);
    EXPECT_EQ(apart.largest, 2);
    const ScalarImage map = difference_map(a, b);
    EXPECT_TRUE(std::isnan(map.at(0, 0)));
    EXPECT_TRUE(std::isnan(map.at(1, 0)));
    EXPECT_EQ(map.at(2, 0), 0);
}

TEST(ImageDifference, map_holds_the_largest_channel_and_the_signed_one_all) {
    Image a(1, 1), b(1, 1);
    a.at(0, 0) = {1, 2, 3};
    b.at(0, 0) = {1.5f, 5, 2};
    EXPECT_EQ(difference_map(a, b).at(0, 0), 3);
    EXPECT_EQ(signed_difference(a, b).at(0, 0), vec3(-0.5f, -3, 1));
}

TEST(ImageDifference, images_of_different_sizes_are_refused) {
    EXPECT_THROW(compare_images(Image(2, 3), Image(3, 2)), std::invalid_argument);
    EXPECT_THROW(difference_map(Image(2, 3), Image(3, 2)), std::invalid_argument);
    EXPECT_THROW(signed_difference(Image(2, 3), Image(2, 2)), std::invalid_argument);
}

}  // namespace
}  // namespace rayshoot
