#include "accel/simd/lanes.h"
#include "accel/core/neighbour.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

/// Vector functions against what they stand for, lane by lane.
namespace rayshoot::simd {
namespace {

constexpr std::size_t width = 8;
constexpr auto tag = floats<width>;
using Row = std::array<float, width>;

auto load(const Row& row) { return hn::LoadU(tag, row.data()); }
template <class V>
Row store(V v) {
    Row row;
    hn::StoreU(v, tag, row.data());
    return row;
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

TEST(Lanes, larger_and_smaller_keep_the_second_where_one_is_nan) {
    const Row a{1, 2, nan, 3, nan, -0.0f, infinite, -1}, b{2, 1, 5, nan, nan, 0.0f, nan, -infinite};
    const Row up = store(larger(load(a), load(b))), down = store(smaller(load(a), load(b)));
    for (std::size_t i = 0; i < width; ++i) {
        const float wanted_up = a[i] > b[i] ? a[i] : b[i], wanted_down = a[i] < b[i] ? a[i] : b[i];
        EXPECT_EQ(std::bit_cast<std::uint32_t>(up[i]), std::bit_cast<std::uint32_t>(wanted_up))
            << i;
        EXPECT_EQ(std::bit_cast<std::uint32_t>(down[i]), std::bit_cast<std::uint32_t>(wanted_down))
            << i;
    }
}

TEST(Lanes, below_is_float_below) {
    Row row;
    for (std::uint64_t bits = 0; bits <= 0xffffffff; bits += 1021 * width) {
        for (std::size_t i = 0; i < width; ++i)
            row[i] = std::bit_cast<float>(static_cast<std::uint32_t>(bits + 1021 * i));
        const Row found = store(below(load(row)));
        for (std::size_t i = 0; i < width; ++i)
            if (!std::isnan(row[i])) {
                ASSERT_EQ(found[i], float_below(row[i])) << row[i];
            }
    }
    const Row ends{0,
                   -0.0f,
                   infinite,
                   -infinite,
                   1,
                   -1,
                   std::numeric_limits<float>::max(),
                   std::numeric_limits<float>::lowest()};
    const Row found = store(below(load(ends)));
    for (std::size_t i = 0; i < width; ++i) EXPECT_EQ(found[i], float_below(ends[i])) << ends[i];
}

template <std::size_t Width>
void expect_every_set_moves_to_the_front() {
    const Row row{10, 11, 12, 13, 14, 15, 16, 17};
    for (std::uint32_t set = 0; set < 1u << Width; ++set) {
        Row found;
        hn::StoreU(compress(hn::LoadU(floats<Width>, row.data()), set), floats<Width>,
                   found.data());
        std::size_t place = 0;
        for (std::size_t i = 0; i < Width; ++i)
            if ((set >> i & 1) != 0) {
                ASSERT_EQ(found[place++], row[i]) << set;
            }
    }
}

TEST(Lanes, compress_moves_every_set_of_lanes_to_the_front) {
    expect_every_set_moves_to_the_front<8>();
    expect_every_set_moves_to_the_front<4>();
}

TEST(Lanes, bits_are_the_lanes_of_a_mask) {
    for (std::uint32_t set = 0; set < 256; ++set) {
        Row row;
        for (std::size_t i = 0; i < width; ++i) row[i] = (set >> i & 1) != 0 ? 1.0f : -1.0f;
        EXPECT_EQ(bits(tag, hn::Gt(load(row), hn::Zero(tag))), set);
    }
}

}  // namespace
}  // namespace rayshoot::simd
