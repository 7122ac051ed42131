#pragma once

#include <cstdint>

/// The first two dimensions of Sobol's sequence, and Owen's scrambling of its points and of their
/// order by a hash (Burley 2020). Here a number in [0, 1) is a word whose lowest bit is the first
/// binary digit: so a carry runs towards finer digits, and arithmetic itself scrambles.
namespace rayshoot {

constexpr std::uint32_t reversed_bits(std::uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    // The bytes: one instruction.
    return x >> 24 | (x >> 8 & 0xff00u) | (x & 0xff00u) << 8 | x << 24;
}

/// Flips each binary digit, or not, by a hash of `seed` and all the digits before it: a nested
/// uniform scrambling (Owen 1995). The hash is Vegdahl's (psychopath.io 2021: Building a better LK
/// hash), in the manner of Laine & Karras 2011.
constexpr std::uint32_t owen_scrambled(std::uint32_t digits, std::uint32_t seed) {
    digits ^= digits * 0x3d20adeau;  // an even factor: no digit depends on itself
    digits += seed;
    digits *= seed >> 16 | 1;
    digits ^= digits * 0x05526c56u;
    digits ^= digits * 0x53a22864u;
    return digits;
}

/// The same of an integer's bits from the highest on: a permutation of the indices of a sequence
/// that carries each aligned block of 2^k indices, in another order, to an aligned block.
constexpr std::uint32_t shuffled(std::uint32_t index, std::uint32_t seed) {
    return reversed_bits(owen_scrambled(reversed_bits(index), seed));
}

/// Digits of the second dimension, the first being those of `index` itself (van der Corput 1935).
/// Its generator matrix is Pascal's triangle modulo 2. By Lucas' theorem C(j, i) is odd if the bits
/// of i are among those of j, so the product is a sum over supersets: five butterflies.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    index ^= index >> 1 & 0x55555555u;
    index ^= index >> 2 & 0x33333333u;
    index ^= index >> 4 & 0x0f0f0f0fu;
    index ^= index >> 8 & 0x00ff00ffu;
    return index ^ index >> 16;
}

}  // namespace rayshoot
