#pragma once

#include "accel/core/isa.h"

#include <array>
#include <cstddef>
#include <cstring>

/// Rows to columns, in registers: g++'s and clang's portable vectors, so it compiles to whatever
/// the instruction set has.
namespace rayshoot::inline RAYSHOOT_ISA {

/// Writes float j of row i to columns[j][i], for 8 rows of 8 floats that lie `stride` bytes apart.
inline void transpose_8x8(const std::byte* rows, std::size_t stride,
                          const std::array<float*, 8>& columns) {
    using Eight = float __attribute__((vector_size(32)));
    std::array<Eight, 8> row, pair, four;
    for (std::size_t i = 0; i < 8; ++i) std::memcpy(&row[i], rows + i * stride, sizeof(Eight));
    // Each step interleaves within the two halves of a register; the last one swaps halves.
    for (std::size_t i = 0; i < 8; i += 2) {
        pair[i] = __builtin_shufflevector(row[i], row[i + 1], 0, 8, 1, 9, 4, 12, 5, 13);
        pair[i + 1] = __builtin_shufflevector(row[i], row[i + 1], 2, 10, 3, 11, 6, 14, 7, 15);
    }
    for (std::size_t i = 0; i < 8; i += 4)
        for (std::size_t j = i; j < i + 2; ++j) {
            const std::size_t to = i + 2 * (j - i);
            four[to] = __builtin_shufflevector(pair[j], pair[j + 2], 0, 1, 8, 9, 4, 5, 12, 13);
            four[to + 1] =
                __builtin_shufflevector(pair[j], pair[j + 2], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (std::size_t j = 0; j < 4; ++j) {
        const Eight low = __builtin_shufflevector(four[j], four[j + 4], 0, 1, 2, 3, 8, 9, 10, 11);
        const Eight high =
            __builtin_shufflevector(four[j], four[j + 4], 4, 5, 6, 7, 12, 13, 14, 15);
        std::memcpy(columns[j], &low, sizeof low);
        std::memcpy(columns[j + 4], &high, sizeof high);
    }
}

}  // namespace rayshoot::inline RAYSHOOT_ISA
