#pragma once

#include <bit>
#include <cassert>
#include <cstdint>

namespace rayshoot {

/// `steps` further round a circle of `length`; both index and steps are less than it.
constexpr std::uint32_t turned(std::uint32_t index, std::uint32_t steps, std::uint32_t length) {
    const std::uint32_t left = length - steps;
    return index < left ? index + steps : index - left;
}

/// Where the permutation of 0..length-1 that `key` names sends `index`: no table, no state.
/// `length` is 1 to 2^31, `key` 64 random bits. As Kensler 2013: steps that are bijections of the
/// next power of two, walked until they come back into the range (two walks at most, on average),
/// then a rotation, so that each index goes everywhere equally often. The steps are ours, with more
/// of the key in each: his reach only 8 of the 24 permutations of four numbers.
constexpr std::uint32_t permuted(std::uint32_t index, std::uint32_t length, std::uint64_t key) {
    assert(index < length);
    constexpr int rounds = 4;  // three leave 3 % between the frequencies of the 24
    const int bits = std::bit_width(length - 1), half = (bits + 1) / 2;
    const std::uint32_t mask = (1u << bits) - 1;
    do {
        auto round_key = static_cast<std::uint32_t>(key);
        for (int round = 0; round < rounds; ++round) {
            // Knuth's multiplicative hash; any odd addend makes it a generator.
            round_key = round_key * 0x9e3779b1u + 0x7f4a7c15u;
            index = (index + (round_key >> 16)) & mask;
            index ^= index >> half;
            index = index * (round_key >> 7 | 1) & mask;
            index ^= index >> 1 & (0 - (round_key >> 31));
        }
    } while (index >= length);
    return turned(index, static_cast<std::uint32_t>((key >> 32) * length >> 32), length);
}

}  // namespace rayshoot
