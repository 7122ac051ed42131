#include "tracer/sampling/permutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

#include "tests/tracer/sampling/chi_squared.h"
#include "tracer/random.h"
#include "tracer/sampling/permutations.h"

namespace rayshoot {
namespace {

constexpr std::uint32_t lengths[] = {1,  2,  3,  4,  5,  7,   8,    9,   15,
                                     16, 17, 25, 36, 64, 100, 1024, 4097};

template <class Permutation>
std::vector<std::uint32_t> all(std::uint32_t length, Permutation&& permutation) {
    std::vector<std::uint32_t> images;
    for (std::uint32_t i = 0; i < length; ++i) images.push_back(permutation(i));
    return images;
}

bool is_permutation(std::vector<std::uint32_t> images) {
    std::ranges::sort(images);
    for (std::uint32_t i = 0; i < images.size(); ++i) {
        if (images[i] != i) return false;
    }
    return true;
}

TEST(Permutation, each_key_permutes_any_length) {
    for (const std::uint32_t length : lengths) {
        const Permutations tabled(length, 1);
        for (std::uint64_t i = 0; i < 50; ++i) {
            const std::uint64_t key = scrambled(i);
            EXPECT_TRUE(is_permutation(
                all(length, [&](std::uint32_t index) { return permuted(index, length, key); })));
            EXPECT_TRUE(is_permutation(
                all(length, [&](std::uint32_t index) { return tabled(index, key); })));
        }
    }
}

TEST(Permutation, stays_in_range_for_the_largest_length) {
    constexpr std::uint32_t largest = 1u << 31;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        EXPECT_LT(permuted(largest - 1 - i, largest, scrambled(i)), largest);
    }
}

/// Null hypothesis: all 24 permutations of four numbers are equally frequent, 24000 keys.
TEST(Permutation, all_permutations_of_four_are_equally_frequent) {
    std::map<std::vector<std::uint32_t>, std::size_t> number;
    Histogram histogram(24);
    for (std::uint64_t i = 0; i < 24000; ++i) {
        const auto images =
            all(4, [&](std::uint32_t index) { return permuted(index, 4, scrambled(i)); });
        histogram.add(number.try_emplace(images, number.size()).first->second);
    }
    EXPECT_TRUE(histogram.uniform());
}

/// Null hypothesis: over keys, an index is sent everywhere equally often; 20000 keys a length.
template <class Make>
void expect_each_index_everywhere(Make&& make) {
    for (const std::uint32_t length : {3u, 4u, 9u, 16u, 25u, 64u}) {
        const auto permutation = make(length);
        for (const std::uint32_t index : {0u, length / 2, length - 1}) {
            Histogram histogram(length);
            for (std::uint64_t i = 0; i < 20000; ++i) {
                histogram.add(permutation(index, scrambled(7 * i + 1)));
            }
            EXPECT_TRUE(histogram.uniform()) << index << " of " << length;
        }
    }
}

TEST(Permutation, sends_each_index_everywhere_equally_often) {
    expect_each_index_everywhere([](std::uint32_t length) {
        return [length](std::uint32_t index, std::uint64_t key) {
            return permuted(index, length, key);
        };
    });
}

TEST(Permutation, tables_send_each_index_everywhere_equally_often) {
    expect_each_index_everywhere([](std::uint32_t length) { return Permutations(length, 1); });
}

/// Null hypothesis: two neighbours are sent to each pair of places equally often, 20000 keys. By
/// tables the pairs are those of some hundred permutations, turned: near that, not tested so.
TEST(Permutation, sends_neighbours_to_independent_places) {
    for (const std::uint32_t length : {5u, 9u, 16u}) {
        Histogram histogram(std::size_t{length} * length);
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const std::uint64_t key = scrambled(i);
            histogram.add(permuted(1, length, key) * length + permuted(2, length, key));
        }
        const double pairs = length * (length - 1);
        EXPECT_TRUE(histogram.agrees([&](std::size_t bin) {
            return bin / length == bin % length ? 0 : 1 / pairs;
        })) << length;
    }
}

/// Root mean square over the places of a neighbour, relative to a place's expected share.
TEST(Permutation, tables_send_neighbours_to_places_independent_within_a_tenth) {
    for (const std::uint32_t length : {9u, 16u, 64u}) {
        const Permutations permutations(length, 1);
        constexpr int keys = 400000;
        std::vector<double> counts(length);
        for (std::uint64_t i = 0; i < keys; ++i) {
            const std::uint64_t key = scrambled(i);
            const std::uint32_t ahead = permutations(2, key) + length - permutations(1, key);
            ++counts[ahead % length];
        }
        EXPECT_EQ(counts[0], 0);
        double squares = 0;
        for (std::size_t i = 1; i < length; ++i) {
            squares += std::pow(counts[i] * (length - 1) / keys - 1, 2);
        }
        EXPECT_LT(std::sqrt(squares / (length - 1)), 0.1) << length;
    }
}

}  // namespace
}  // namespace rayshoot
