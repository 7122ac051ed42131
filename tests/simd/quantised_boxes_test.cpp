#include "accel/simd/quantised_boxes.h"
#include "accel/simd/wide_box.h"
#include "tests/core/cases.h"

#include <gtest/gtest.h>

#include <bit>

/// Decoded boxes contain the boxes that they stand for, exactly, whatever these are.
namespace rayshoot {
namespace {

constexpr std::size_t width = QuantisedBoxes::width;
constexpr float largest = std::numeric_limits<float>::max();
constexpr float denormal = std::numeric_limits<float>::denorm_min();

Boxes<width> side_by_side(std::span<const Box> boxes) {
    Boxes<width> result;
    for (std::size_t i = 0; i < boxes.size(); ++i) result.set(i, boxes[i]);
    return result;
}

/// A plane that is NaN bounds nothing.
void expect_contained(std::span<const Box> boxes) {
    const Boxes<width> exact = side_by_side(boxes);
    const QuantisedBoxes quantised(exact);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float lo = exact.planes[axis][i], hi = exact.planes[axis + 3][i];
            ASSERT_FALSE(plane(quantised, axis, axis, i) > lo) << std::hexfloat << lo;
            ASSERT_FALSE(plane(quantised, axis, axis + 3, i) < hi) << std::hexfloat << hi;
        }
}

Box between(const vec3& p, const vec3& q) {
    Box box;
    box.include(p);
    box.include(q);
    return box;
}

/// Up to eight, about a place, of sizes that differ.
std::vector<Box> some_boxes(double place, double size, cases::Random& random) {
    const vec3 centre = random.in_cube(place);
    std::vector<Box> boxes;
    for (std::uint32_t i = 0, count = 1 + random.below(width); i < count; ++i) {
        const vec3 p = centre + random.in_cube(size);
        boxes.push_back(between(p, p + random.in_cube(size * std::exp2(-random.uniform(0, 30)))));
    }
    return boxes;
}

TEST(QuantisedBoxes, contain_boxes_of_any_size_at_any_place) {
    cases::Random random(1);
    for (int i = 0; i < 200000; ++i) {
        const double place = std::exp2(random.uniform(-149, 127));
        expect_contained(some_boxes(place, place * std::exp2(random.uniform(-30, 30)), random));
        if (HasFatalFailure()) return;
    }
}

TEST(QuantisedBoxes, contain_boxes_with_any_bits) {
    cases::Random random(2);
    const auto any = [&] {
        while (true) {
            const auto bits = random.below(1u << 16) << 16 | random.below(1u << 16);
            const auto value = std::bit_cast<float>(bits);
            if (!std::isnan(value)) return value;
        }
    };
    for (int i = 0; i < 200000; ++i) {
        std::vector<Box> boxes;
        for (std::uint32_t j = 0, count = 1 + random.below(width); j < count; ++j)
            boxes.push_back(between({any(), any(), any()}, {any(), any(), any()}));
        expect_contained(boxes);
        if (HasFatalFailure()) return;
    }
}

TEST(QuantisedBoxes, contain_ends_of_the_range) {
    const float ends[] = {0,        -0.0f,         denormal, -denormal, 0x1p-126f,
                          1,        0x1.fffffep0f, -1,       1e8f,      0x1p126f,
                          0x1p127f, largest,       -largest, infinity,  -infinity};
    for (const float a : ends)
        for (const float b : ends)
            for (const float c : ends) {
                const Box flat = between(vec3(a), vec3(a)), one = between({a, b, c}, {b, c, a}),
                          other = between({c, c, a}, {c, a, a});
                for (const auto& boxes :
                     {std::vector{flat}, std::vector{one}, std::vector{flat, one, other, flat}})
                    expect_contained(boxes);
                if (HasFatalFailure()) return;
            }
}

/// By more than a cell only where floats are not dense enough for the cells.
TEST(QuantisedBoxes, are_hardly_larger) {
    cases::Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const std::vector<Box> boxes = some_boxes(1, std::exp2(random.uniform(-8, 8)), random);
        const Boxes<width> exact = side_by_side(boxes);
        const QuantisedBoxes quantised(exact);
        Box all;
        for (const Box& box : boxes) all.include(box);
        for (std::size_t j = 0; j < boxes.size(); ++j)
            for (std::size_t place = 0; place < 6; ++place) {
                const std::size_t axis = place % 3;
                const float cell = 2 * all.size()[static_cast<int>(axis)] / 255;
                ASSERT_NEAR(plane(quantised, axis, place, j), exact.planes[place][j],
                            1.001f * cell + 1e-6f);
            }
    }
}

TEST(QuantisedBoxes, that_are_flat_stay_flat) {
    const Box flat = between({1.1f, 2.2f, -3.3f}, {4.4f, 2.2f, -1});
    const QuantisedBoxes quantised(side_by_side(std::vector{flat, flat}));
    EXPECT_EQ(plane(quantised, 1, 1, 0), 2.2f);
    EXPECT_EQ(plane(quantised, 1, 4, 1), 2.2f);
}

TEST(QuantisedBoxes, decode_a_row_to_its_planes) {
    cases::Random random(4);
    for (int i = 0; i < 10000; ++i) {
        const double place = std::exp2(random.uniform(-149, 127));
        const QuantisedBoxes quantised(
            side_by_side(some_boxes(place, place * std::exp2(random.uniform(-30, 30)), random)));
        for (std::size_t place_of_row = 0; place_of_row < 6; ++place_of_row) {
            const std::size_t axis = place_of_row % 3;
            std::array<float, width> planes;
            simd::hn::StoreU(row(quantised, axis, place_of_row * width), simd::floats<width>,
                             planes.data());
            for (std::size_t j = 0; j < width; ++j)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(planes[j]),
                          std::bit_cast<std::uint32_t>(plane(quantised, axis, place_of_row, j)));
        }
    }
}

TEST(QuantisedBoxes, limit_rays_where_there_is_no_box) {
    const Box box = between(vec3(0), vec3(1));
    for (std::size_t count = 0; count <= width; ++count) {
        const QuantisedBoxes quantised(side_by_side(std::vector(count, box)));
        std::array<float, width> limits;
        simd::hn::StoreU(limit(quantised, 5), simd::floats<width>, limits.data());
        for (std::size_t i = 0; i < width; ++i) {
            if (i < count) EXPECT_EQ(limits[i], 5);
            else EXPECT_TRUE(std::isnan(limits[i]));
        }
    }
}

}  // namespace
}  // namespace rayshoot
