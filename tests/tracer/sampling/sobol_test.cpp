#include "tracer/sampling/sobol.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <vector>

#include "tests/tracer/sampling/chi_squared.h"
#include "tracer/random.h"

namespace rayshoot {
namespace {

std::uint32_t seed(std::uint64_t i) { return static_cast<std::uint32_t>(scrambled(i)); }

TEST(Sobol, bits_are_reversed) {
    EXPECT_EQ(reversed_bits(1), 0x80000000u);
    for (std::uint32_t i = 0; i < 1000; ++i) {
        std::uint32_t expected = 0;
        for (int bit = 0; bit < 32; ++bit) expected |= (seed(i) >> bit & 1) << (31 - bit);
        EXPECT_EQ(reversed_bits(seed(i)), expected);
    }
}

/// Sobol's recurrence for the primitive polynomial x + 1 with m1 = 1: v(j) = v(j-1) + v(j-1) / 2
/// without carry (Bratley & Fox 1988).
TEST(Sobol, the_second_dimension_follows_the_recurrence) {
    std::uint32_t direction = 0x80000000u;
    for (int bit = 0; bit < 32; ++bit) {
        EXPECT_EQ(reversed_bits(sobol_second(1u << bit)), direction) << bit;
        direction ^= direction >> 1;
    }
    for (std::uint32_t i = 0; i < 1000; ++i) {  // linear: so those are enough
        EXPECT_EQ(sobol_second(seed(i) ^ seed(i + 1)),
                  sobol_second(seed(i)) ^ sobol_second(seed(i + 1)));
    }
}

TEST(Sobol, starts_as_published) {  // points 0 to 7 in eighths, in the order of the van der Corput
    const std::uint32_t first[] = {0, 4, 2, 6, 1, 5, 3, 7}, second[] = {0, 4, 6, 2, 5, 1, 3, 7};
    for (std::uint32_t i = 0; i < 8; ++i) {
        EXPECT_EQ(reversed_bits(i) >> 29, first[i]);
        EXPECT_EQ(reversed_bits(sobol_second(i)) >> 29, second[i]);
    }
}

/// Of two numbers that first differ in digit d, the images first differ there, too: digits depend
/// on those before only, and each is flipped or not. So each word occurs once.
TEST(Owen, a_digit_depends_on_those_before_it) {
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const std::uint32_t digits = seed(i), other = seed(i + 1) << (i % 32) ^ digits;
        EXPECT_EQ(std::countr_zero(owen_scrambled(digits, seed(i + 7)) ^
                                   owen_scrambled(other, seed(i + 7))),
                  std::countr_zero(digits ^ other));
    }
}

/// Null hypothesis: once two numbers have parted at a digit, the next three digits of their images
/// are independent: 64 pairs equally frequent, 10^5 seeds. The variance of scrambled nets rests on
/// this (Owen 1997).
TEST(Owen, digits_of_two_numbers_are_independent_after_they_part) {
    for (int parting = 0; parting < 6; ++parting) {
        for (const std::uint32_t first : {0u, 1u, 5u, 0x2545f491u}) {
            const std::uint32_t second = first ^ 1u << parting;
            Histogram histogram(64);
            for (std::uint64_t i = 0; i < 100000; ++i) {
                const auto next = [&](std::uint32_t digits) {
                    return owen_scrambled(digits, seed(i)) >> (parting + 1) & 7;
                };
                histogram.add(next(first) << 3 | next(second));
            }
            EXPECT_TRUE(histogram.uniform()) << first << " from digit " << parting;
        }
    }
}

/// Null hypothesis: an image's first eight digits are uniform, 10^5 seeds.
TEST(Owen, images_are_uniform) {
    for (const std::uint32_t digits : {0u, 1u, 6u, 0x9d2c5680u}) {
        Histogram histogram(256);
        for (std::uint64_t i = 0; i < 100000; ++i) {
            histogram.add(owen_scrambled(digits, seed(i)) & 255);
        }
        EXPECT_TRUE(histogram.uniform()) << digits;
    }
}

/// Whether 2^k points meet every elementary interval of area 2^-k once, of all k + 1 shapes.
bool is_net(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& points) {
    const int k = std::countr_zero(points.size());
    for (int across = 0; across <= k; ++across) {
        std::set<std::uint32_t> met;
        for (const auto& [u, v] : points) {
            const std::uint64_t column = std::uint64_t{u} >> (32 - across);
            const std::uint64_t row = std::uint64_t{v} >> (32 - (k - across));
            met.insert(static_cast<std::uint32_t>(column << (k - across) | row));
        }
        if (met.size() != points.size()) return false;
    }
    return true;
}

TEST(Sobol, scrambled_and_shuffled_blocks_are_nets) {
    for (int k = 0; k <= 8; ++k) {
        for (std::uint64_t i = 0; i < 20; ++i) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> points;
            const std::uint32_t block = seed(4 * i) << k;
            for (std::uint32_t sample = 0; sample < 1u << k; ++sample) {
                const std::uint32_t index = shuffled(block + sample, seed(4 * i + 1));
                points.emplace_back(
                    reversed_bits(owen_scrambled(index, seed(4 * i + 2))),
                    reversed_bits(owen_scrambled(sobol_second(index), seed(4 * i + 3))));
            }
            EXPECT_TRUE(is_net(points)) << "2^" << k;
        }
    }
}

}  // namespace
}  // namespace rayshoot
